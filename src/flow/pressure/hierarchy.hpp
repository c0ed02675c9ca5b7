#pragma once
#include <vector>

#include "grid/grid.hpp"

namespace washtub {

/// Extent of one multigrid level over the whole box.
template <int D>
struct Coarsening {
  Index<D> factor;  ///< cells of the finer level per cell of this one
  Index<D> cells;
  Vec<D> h;
  bool gathered;  ///< held whole by every rank
};

/// Cells of a coarser level along an axis of n cells. The last one of an odd number has one child;
/// its missing half counts as solid.
inline int coarse_count(int n, int factor) { return (n + factor - 1) / factor; }

/// Levels below the mesh, of any number of cells: each doubles every axis whose spacing is under
/// 1.4 times the smallest of those with more than one cell, so flat cells are first coarsened along
/// their short edge. A function of the mesh alone, hence equal on every number of ranks. At least
/// one level, the last of them small.
/// @throws InputError where there are too few cells for even one level.
template <int D>
std::vector<Coarsening<D>> coarsen(const Mesh<D>& mesh);

/// Multiples on which block edges within the box must lie so that no coarse cell straddles two
/// ranks.
template <int D>
Granularity<D> granularity(const Mesh<D>& mesh);

}  // namespace washtub
