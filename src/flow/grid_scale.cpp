#include "flow/grid_scale.hpp"

#include <algorithm>

namespace washtub {
namespace {

constexpr double least = 0.01;  // of the energy of water that moves at the speed of what drives it

/// Sums of squares, of what the three-point mean leaves and of all, and the number of faces.
struct Squares {
  double left = 0, all = 0, faces = 0;
};

/// Adds the faces of a row, whose neighbours along the axis are s values away.
void add_row(const double* u, const float* open, long s, int n, Squares& sum) {
  double left = 0, all = 0, faces = 0;
#pragma omp simd reduction(+ : left, all, faces)
  for (int i = 0; i < n; ++i) {
    const double inside = open[i - s] * open[i] * open[i + s];
    const double rest = 0.25 * (u[i] - u[i - s] + u[i] - u[i + s]);
    left += inside * rest * rest;
    all += inside * u[i] * u[i];
    faces += inside;
  }
  sum.left += left;
  sum.all += all;
  sum.faces += faces;
}

}  // namespace

template <int D>
Vec<D> grid_scale_energy(const Grid<D>& grid, const std::array<Field, D>& u,
                         const std::array<const float*, D>& open, double speed) {
  const auto& block = grid.block();
  std::array<Squares, D> sums{};
  for (int axis = 0; axis < D; ++axis)
    for (int c = 0; c < D; ++c)
      for (int k = 0; k < block.planes(); ++k)
        for (int j = 0; j < block.rows(); ++j) {
          const long p = block.row(j, k);
          add_row(u[c].data() + p, open[c] + p, block.stride[axis], block.width(), sums[axis]);
        }
  grid.parallel().sum(std::span<double>(&sums[0].left, 3 * D));
  Vec<D> share;
  for (int axis = 0; axis < D; ++axis) {
    const Squares& sum = sums[axis];
    const double all = std::max(sum.all, least * speed * speed * sum.faces / D);
    share[axis] = all > 0 ? sum.left / all : 0;
  }
  return share;
}

template Vec<2> grid_scale_energy<2>(const Grid<2>&, const std::array<Field, 2>&,
                                     const std::array<const float*, 2>&, double);
template Vec<3> grid_scale_energy<3>(const Grid<3>&, const std::array<Field, 3>&,
                                     const std::array<const float*, 3>&, double);

}  // namespace washtub
