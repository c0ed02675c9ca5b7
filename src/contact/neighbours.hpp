#pragma once
#include <limits>
#include <utility>
#include <vector>

#include "cloth/cloth.hpp"
#include "grid/mesh.hpp"

namespace washtub {

/// What of the cloth is near to what.
struct Neighbours {
  static constexpr double none = std::numeric_limits<double>::infinity();

  double gap = none;  ///< the smallest distance of two pieces, where it is within reach [m]
  /// Of two parts of a piece whose distance at rest is more than 1.5 times the reach [m].
  double own_gap = none;
  std::vector<std::pair<int, int>> nodes;  ///< of different pieces within reach, in order
};

/// Looks as far as `reach` [m].
template <int D>
Neighbours find_neighbours(const Cloth<D>& cloth, const Mesh<D>& mesh, double reach);

}  // namespace washtub
