#include "solid/surface_speed.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

/// Calls visit(solid, position) for the closed face of each pair that lies beside an open one.
template <int D, class Visit>
void for_surface(const Grid<D>& grid, const DomainMapping<D>& mapping, int c, int axis,
                 Visit&& visit) {
  const auto& block = grid.block();
  const float* open = mapping.open()[c];
  const std::uint8_t* owner = mapping.owner(c);
  Index<D> cell{};
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j) {
      if constexpr (D == 3) cell[1] = j;
      cell[D - 1] = k;
      for (int i = 0; i < block.width(); ++i) {
        cell[0] = i;
        const bool last = cell[axis] == block.count[axis] - 1;
        if (axis != c && last && grid.at_side(axis, 1)) continue;  // nothing is beyond
        const long p = block.row(j, k) + i, q = p + block.stride[axis];
        if ((open[p] > 0) == (open[q] > 0)) continue;
        Vec<D> x = grid.position(cell, c);
        if (open[p] > 0) x[axis] += grid.mesh().h[axis];
        if (open[p] > 0 && block.offset[axis] + cell[axis] == grid.mesh().cells[axis] - 1 &&
            grid.mesh().periodic[axis])
          x[axis] -= grid.mesh().size()[axis];  // the ghost's own place
        visit(owner[open[p] > 0 ? q : p], x);
      }
    }
}

}  // namespace

template <int D>
double fastest_surface(const Grid<D>& grid, const DomainMapping<D>& mapping) {
  const auto& solids = mapping.solids();
  double fastest = 0;
  for (int c = 0; c < D; ++c)
    for (int axis = 0; axis < D; ++axis)
      for_surface(grid, mapping, c, axis, [&](std::size_t s, const Vec<D>& x) {
        if (s >= solids.size()) return;  // a side of the box
        const Vec<3>& centre = solids[s].centre;
        fastest = std::max(fastest,
                           solids[s].drive.peak() * std::hypot(x[0] - centre[0], x[1] - centre[1]));
      });
  return grid.parallel().max(fastest);
}

template double fastest_surface<2>(const Grid<2>&, const DomainMapping<2>&);
template double fastest_surface<3>(const Grid<3>&, const DomainMapping<3>&);

}  // namespace washtub
