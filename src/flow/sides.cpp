#include "flow/sides.hpp"

namespace washtub {

template <int D>
Sides<D>::Sides(const Grid<D>& grid, const std::array<std::array<Side<D>, 2>, D>& sides)
    : grid_(grid), sides_(sides) {
  for (int d = 0; d < D; ++d)
    for (int side = 0; side < 2; ++side) here_[d][side] = grid.at_side(d, side);
}

template <int D>
void Sides<D>::mirror_onto(int c, int axis, int side, const double* from, double* to) const {
  const auto& s = sides_[axis][side];
  const double sign = s.kind == Side<D>::Kind::slip ? 1.0 : -1.0;
  const double twice = s.kind == Side<D>::Kind::slip ? 0.0 : 2 * s.velocity[c];
  const int n = grid_.block().width();
#pragma omp simd
  for (int i = -1; i <= n; ++i) to[i] = twice + sign * from[i];
}

template <int D>
void Sides<D>::mirror_row(int c, double* u, int j, int k) const {
  const auto& block = grid_.block();
  double* row = u + block.row(j, k);
  const int n = block.width();
  const auto x_ghost = [&](int side, double inside) {
    const auto& s = sides_[0][side];
    return s.kind == Side<D>::Kind::slip ? inside : 2 * s.velocity[c] - inside;
  };
  if (c != 0) {
    if (here_[0][0]) row[-1] = x_ghost(0, row[0]);
    if (here_[0][1]) row[n] = x_ghost(1, row[n - 1]);
  }
  for (int axis = 1; axis < D; ++axis) {
    if (c == axis) continue;
    const int at = axis == D - 1 ? k : j;
    const long s = block.stride[axis];
    if (at == 0 && here_[axis][0]) mirror_onto(c, axis, 0, row, row - s);
    if (at == block.count[axis] - 1 && here_[axis][1]) mirror_onto(c, axis, 1, row, row + s);
  }
}

template <int D>
void Sides<D>::mirror(int c, double* u) const {
  for (int k = 0; k < grid_.block().planes(); ++k)
    for (int j = 0; j < grid_.block().rows(); ++j) mirror_row(c, u, j, k);
}

template class Sides<2>;
template class Sides<3>;

}  // namespace washtub
