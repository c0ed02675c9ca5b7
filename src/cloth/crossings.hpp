#pragma once
#include <array>
#include <set>

#include "cloth/cloth.hpp"
#include "grid/mesh.hpp"

namespace washtub {

/// Edges of the cloth's mesh of nodes and how many of them pass through cloth.
struct Crossings {
  long edges = 0;
  long others = 0;                        ///< pass through another piece
  long own = 0;                           ///< pass through their own piece
  std::set<std::array<int, 2>> pieces{};  ///< that cross, each pair once, the lower one first

  /// Of the edges, those that pass through another piece.
  double share() const {
    return edges > 0 ? static_cast<double>(others) / static_cast<double>(edges) : 0;
  }
};

/// Counts the edges along r and s that pass through a triangle (2-D: a segment) they have no node
/// in common with. Each quad of nodes is cut into two triangles, by diagonals that alternate from
/// quad to quad. An edge that only touches, also at its own end, does not count. Closed sheets are
/// taken across their seams, and periodic sides of the box let cloth meet the images of other cloth
/// beyond them; all elements are taken to be shorter than half the box. All
/// zero where a place is not finite.
template <int D>
Crossings find_crossings(const Cloth<D>& cloth, const Mesh<D>& mesh);

}  // namespace washtub
