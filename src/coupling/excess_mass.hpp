#pragma once
#include <vector>

#include "cloth/cloth.hpp"

namespace washtub {

/// The mass of each node beyond that of the water it displaces: its weight and its inertia.
template <int D>
class ExcessMass {
 public:
  using Nodes = std::vector<Vec<D>>;

  explicit ExcessMass(const Cloth<D>& cloth);

  void set_gravity(const Vec<D>& gravity) { gravity_ = gravity; }  ///< [m/s^2]
  double mass(int node) const { return mass_[node]; }              ///< [kg]
  double weight(int node, int component) const { return mass_[node] * gravity_[component]; }

  /// Weight and inertia of each node on the water [N], as found last.
  const Nodes& force() const { return force_; }
  /// Finds them with the acceleration between the last two steps, of which the latter took `before`
  /// (0 if there was none) [s].
  void find_lagging(double before);
  /// Finds those of one node with the acceleration that takes it to `next` in a step dt.
  void find(int node, int component, const Nodes& next, double dt);

 private:
  const Cloth<D>& cloth_;
  std::vector<double> mass_;
  Vec<D> gravity_ = Vec<D>::Zero();
  Nodes force_;
};

}  // namespace washtub
