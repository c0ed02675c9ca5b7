#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/phase_clock.hpp"
#include "coupling/coupling_scheme.hpp"
#include "coupling/immersed_boundary.hpp"

namespace washtub {

/// Moves cloth and water together. Between Flow::predict and Flow::project, push() finds the
/// cloth's force on the water; after each projection, again() says whether the cloth asks for
/// another one; then move() brings the cloth to its new place. Calls in any other order throw
/// std::logic_error. The step is that of the flow.
///
/// A pinned node stays where it is, and its force on the water is the last one less m_i U / dt,
/// with U what the water's velocity there would become otherwise and m_i the ghost mass of
/// ImplicitScheme. That goes on until the water rests there, or goes through the cloth by Darcy's
/// law.
template <int D>
class Coupling {
 public:
  using Report = CouplingReport<D>;

  /// `clock`: where the scheme's part of the time goes; may be null.
  Coupling(Flow<D>& flow, Cloth<D>& cloth, const DomainMapping<D>& mapping, Kernel kernel,
           const SidePairs<D>& sides, Scheme scheme, double marker_spacing = 2,
           PhaseClock* clock = nullptr, const ContactSettings& contact = {});
  Coupling(const Coupling&) = delete;
  Coupling& operator=(const Coupling&) = delete;

  /// The force acts on the cloth from now on.
  void add(std::unique_ptr<NodalForce<D>> force) { step_.forces.push_back(std::move(force)); }
  /// Of these forces, and of the repulsion of cloth by cloth, since the start [J]; per metre in
  /// 2-D.
  double work_of_forces() const { return step_.work_of_given(); }

  /// On return flow.force() is the force of the cloth on the water during this step.
  /// @throws RunError naming the piece whose solve failed
  void push();
  /// To be asked after each projection. True if another one is needed: then flow.force() is a
  /// better force, and the flow is back at its prediction. Only the Broyden scheme ever needs it.
  /// @throws RunError when the iteration does not converge
  bool again();
  /// On return the cloth is at its new place, outside all solids. Where the scheme does not need to
  /// know how nodes move past the water it is measured only if asked for.
  Report move(bool measure_slip = true);

  void state(Archive& archive) {
    archive.value("step", step_);
    archive.same_length("place of mobility", place_of_mobility_);
    archive.value("age of mobility", age_of_mobility_);
    archive.value("barrier", barrier_);
    archive.value("scheme", *scheme_);
    if (archive.reading()) stage_ = Stage::moved;  // a step that failed is forgotten
  }

  /// Moment of the contact forces on a solid about its axis [N m], in the last step.
  double contact_moment(std::size_t solid) const;

 private:
  static constexpr int lifetime_of_mobility = 4;  ///< most steps for which it is kept
  /// What is done of a step.
  enum class Stage { moved, pushed, settled };

  bool mobility_holds() const;
  void find_water();
  void find_pins();
  void find_velocity();
  void spread_force();
  void measure_slip();

  const DomainMapping<D>& mapping_;
  CoupledStep<D> step_;
  ImmersedBoundary<D> boundary_;
  Barrier<D> barrier_;
  std::optional<Contact<D>> contact_;
  std::unique_ptr<CouplingScheme<D>> scheme_;
  std::vector<Vec<D>> middle_;                  ///< where the delta functions stand [m]
  std::vector<Vec<D>> place_of_mobility_;       ///< where they stood when it was found [m]
  int age_of_mobility_ = lifetime_of_mobility;  ///< in steps
  std::vector<Vec<D>> pin_force_;               ///< of each pinned node on the water [N]
  Stage stage_ = Stage::moved;
};

}  // namespace washtub
