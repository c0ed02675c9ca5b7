#pragma once
#include <array>

#include "grid/grid.hpp"

namespace washtub::testing {

/// A box of unit cells with its lower corner at the origin.
template <int D>
Mesh<D> unit_mesh(const Index<D>& cells, const std::array<bool, D>& periodic) {
  return {Vec<D>::Zero(), Vec<D>::Ones(), cells, periodic};
}

/// Block edges anywhere.
template <int D>
Granularity<D> any_cut() {
  Granularity<D> unit;
  unit.fill(1);
  return unit;
}

/// Calls visit(local cell) for every cell of a block and `ghosts` layers around it.
template <int D, class Visit>
void for_cells(const Block<D>& block, int ghosts, Visit&& visit) {
  const int j0 = D == 3 ? -ghosts : 0, j1 = D == 3 ? block.rows() + ghosts : 1;
  for (int k = -ghosts; k < block.planes() + ghosts; ++k)
    for (int j = j0; j < j1; ++j)
      for (int i = -ghosts; i < block.width() + ghosts; ++i) {
        Index<D> c{};
        c[0] = i;
        if constexpr (D == 3) c[1] = j;
        c[D - 1] = k;
        visit(c);
      }
}

}  // namespace washtub::testing
