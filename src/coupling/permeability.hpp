#pragma once
#include <vector>

#include "cloth/surface.hpp"

namespace washtub {

/// Cloth lets water through by Darcy's law: along its normal n a node goes past the water with
/// P F, P = lambda/A n n^T, where F is its force on the water, A its area at rest, and lambda
/// `Material::permeability`.
template <int D>
class Permeability {
 public:
  Permeability(const Cloth<D>& cloth, const ClothSurface<D>& surface);

  /// Whether any cloth lets water through.
  bool any() const { return !through_.empty(); }
  /// On return P is that of the nodes at X.
  void find(const std::vector<Vec<D>>& X);
  /// P [m/(s N)]; only where any().
  const Mat<D>& operator[](std::size_t node) const { return through_[node]; }

 private:
  const ClothSurface<D>& surface_;
  std::vector<double> over_area_;  ///< lambda/A of each node [m/(s N)]; empty if all are 0
  std::vector<Mat<D>> through_;
  std::vector<Vec<D>> points_, normal_;
};

}  // namespace washtub
