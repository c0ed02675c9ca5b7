#pragma once
#include <vector>

#include "cloth/cloth.hpp"

namespace washtub {

/// Inertia of the mass of each node beyond that of the water it displaces.
template <int D>
class Inertia {
 public:
  using Nodes = std::vector<Vec<D>>;

  explicit Inertia(const Cloth<D>& cloth)
      : cloth_(cloth), mass_(excess_masses(cloth)), force_(mass_.size(), Vec<D>::Zero()) {}

  double mass(int node) const { return mass_[node]; }  ///< [kg]
  /// Of each node on the water [N], as found last.
  const Nodes& force() const { return force_; }
  /// Finds it with the acceleration between the last two steps, of which the latter took `before`
  /// (0 if there was none) [s].
  void find_lagging(double before);
  /// Finds that of one node with the acceleration that takes it to `next` in a step dt.
  void find(int node, int component, const Nodes& next, double dt);

 private:
  const Cloth<D>& cloth_;
  std::vector<double> mass_;
  Nodes force_;
};

}  // namespace washtub
