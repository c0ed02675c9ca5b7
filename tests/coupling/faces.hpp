#pragma once
#include <algorithm>
#include <vector>

#include "coupling/immersed_boundary.hpp"
#include "flow/pressure/multigrid.hpp"
#include "support/dots.hpp"

namespace washtub::testing {

/// `count` points all over the box, some right at its sides.
template <int D>
std::vector<Vec<D>> points_in(const Mesh<D>& mesh, int count) {
  std::vector<Vec<D>> points(count);
  for (int i = 0; i < count; ++i)
    for (int d = 0; d < D; ++d) {
      const double r = 1.2 * scatter(100 * i + d);  // a sixth of them is cut to a side
      points[i][d] =
          mesh.lower[d] + mesh.h[d] * mesh.cells[d] * 0.5 * (1 + std::clamp(r, -0.999, 0.999));
    }
  return points;
}

/// Calls visit(axis, memory position, cell of the whole grid) for the faces of this rank.
template <int D, class Visit>
void for_face_cells(const Grid<D>& grid, Visit&& visit) {
  const auto& block = grid.block();
  for (int d = 0; d < D; ++d)
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (int i = 0; i < block.width(); ++i) {
          Index<D> c = block.row_cell(j, k);
          c[0] += i;
          visit(d, block.row(j, k) + i, c);
        }
}

/// Sets u = value(axis, cell of the whole grid, position) on the faces of this rank.
template <int D, class Value>
void fill_faces(const Grid<D>& grid, std::array<Field, D>& u, Value&& value) {
  for_face_cells(grid, [&](int d, long p, const Index<D>& c) {
    u[d][p] = value(d, c, grid.mesh().position(c, d));
  });
}

/// Calls visit(axis, value, position) for the faces of this rank.
template <int D, class Visit>
void for_faces(const Grid<D>& grid, const std::array<Field, D>& u, Visit&& visit) {
  for_face_cells(grid, [&](int d, long p, const Index<D>& c) {
    visit(d, u[d][p], grid.mesh().position(c, d));
  });
}

template <int D>
std::array<Field, D> make_fields(const Grid<D>& grid) {
  std::array<Field, D> fields;
  for (auto& f : fields) f = grid.make_field();
  return fields;
}

/// Sum of f times the cell volume over all ranks [N].
template <int D>
Vec<D> total(const Grid<D>& grid, const std::array<Field, D>& f) {
  Vec<D> sum = Vec<D>::Zero();
  for_faces<D>(grid, f, [&](int d, double v, const Vec<D>&) { sum[d] += v; });
  sum *= grid.mesh().cell_volume();
  grid.parallel().sum(std::span<double>(sum.data(), D));
  return sum;
}

}  // namespace washtub::testing
