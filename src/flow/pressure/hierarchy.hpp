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

/// Levels below the mesh: each doubles every axis whose spacing is under 1.4 times the smallest, so
/// flat cells are first coarsened along their short edge. A function of the mesh alone, hence equal
/// on every number of ranks. At least one level.
/// @throws InputError where the number of cells cannot be halved even once.
template <int D>
std::vector<Coarsening<D>> coarsen(const Mesh<D>& mesh);

/// Multiples on which block edges must lie so that no coarse cell straddles two ranks.
template <int D>
Granularity<D> granularity(const Mesh<D>& mesh);

}  // namespace washtub
