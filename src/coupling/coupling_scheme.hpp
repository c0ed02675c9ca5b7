#pragma once
#include <memory>

#include "coupling/coupled_step.hpp"
#include "coupling/scheme.hpp"

namespace washtub {

/// How the cloth finds its force on the water and its next place, one class per Scheme. Called once
/// or a few times a step, in the order of the functions.
template <int D>
class CouplingScheme {
 public:
  virtual ~CouplingScheme() = default;

  /// The delta functions stand where the nodes will be after this part of the step.
  virtual double ahead() const { return 0.5; }
  /// Whether push() has to know `mobility` and, before the projection, `water`.
  virtual bool needs_provisional() const { return false; }
  /// Whether again() and move() have to know `water` after the projection.
  virtual bool needs_projected() const { return true; }
  /// On entry `force` is that of the step before; on return that of this one, pinned nodes aside.
  virtual void push() = 0;
  /// After each projection: true if another one is needed. Then `force` is a better one and the
  /// flow is back at its prediction.
  virtual bool again() { return false; }
  /// On return `next` is the new place, nodes too near a surface and pinned ones aside, and its
  /// strain is reported.
  virtual void move() {}
  /// Moment about a vertical axis of the forces that hold nodes off a solid [N m].
  virtual double contact_moment(int /*solid*/, const Vec<3>& /*axis*/) const { return 0; }
  /// What it carries from step to step.
  virtual void state(Archive& /*archive*/) {}
};

/// `contact`: between parts of the cloth; may be null.
template <int D>
std::unique_ptr<CouplingScheme<D>> make_scheme(Scheme scheme, CoupledStep<D>& step,
                                               Barrier<D>& barrier, Contact<D>* contact);

}  // namespace washtub
