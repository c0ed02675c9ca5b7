#pragma once
#include <vector>

#include "base/archive.hpp"
#include "base/vec.hpp"

namespace washtub {

/// The cloth at the start of a step.
template <int D>
struct ClothMoment {
  const std::vector<Vec<D>>& position;  ///< X^n [m]
  /// With which the water carries the nodes, 0 at pinned ones [m/s]; in explicit schemes that of
  /// the step before, with what they move through it where it lets water through. Forces between
  /// sheets that cancel in the water do not change it, so that one against it does not feed on
  /// itself.
  const std::vector<Vec<D>>& velocity;
  double dt;  ///< length of the step that begins [s]
};

/// A force on the nodes that follows from where the cloth is when a step begins and acts all
/// through it.
template <int D>
class NodalForce {
 public:
  virtual ~NodalForce() = default;

  /// Adds the force of each node on the water [N], the same on all ranks (collective).
  virtual void add(const ClothMoment<D>& now, std::vector<Vec<D>>& force) = 0;
  /// What it carries from step to step.
  virtual void state(Archive& /*archive*/) {}
};

}  // namespace washtub
