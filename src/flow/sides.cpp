#include "flow/sides.hpp"

namespace washtub {

template <int D>
typename Sides<D>::Reflection Sides<D>::reflection(const Side<D>& side) {
  using Kind = typename Side<D>::Kind;
  Reflection r;
  r.here = side.kind != Kind::periodic && side.kind != Kind::outflow;
  r.near = side.kind == Kind::slip ? 1 : side.kind == Kind::far_field ? 2 : -1;
  r.next = side.kind == Kind::far_field ? -1 : 0;
  if (side.kind == Kind::wall || side.kind == Kind::inflow) r.twice = 2 * side.velocity;
  return r;
}

template <int D>
Sides<D>::Sides(const Grid<D>& grid, const SidePairs<D>& sides) : grid_(grid) {
  for (int d = 0; d < D; ++d)
    for (int side = 0; side < 2; ++side) {
      reflections_[d][side] = reflection(sides[d][side]);
      reflections_[d][side].here &= grid.at_side(d, side);
    }
}

/// Ghosts of the row that lies `out` values beyond `row`.
template <int D>
void Sides<D>::mirror_onto(int c, const Reflection& r, double* row, long out) const {
  const int n = grid_.block().width();
  const double* next = row - out;
  double* __restrict__ ghost = row + out;
#pragma omp simd
  for (int i = -1; i <= n; ++i) ghost[i] = r(c, row[i], next[i]);
}

template <int D>
void Sides<D>::mirror_row(int c, double* u, int j, int k) const {
  const auto& block = grid_.block();
  double* row = u + block.row(j, k);
  const int n = block.width();
  if (c != 0) {
    const auto& [lower, upper] = reflections_[0];
    if (lower.here) row[-1] = lower(c, row[0], row[1]);
    if (upper.here) row[n] = upper(c, row[n - 1], row[n - 2]);
  }
  for (int axis = 1; axis < D; ++axis) {
    if (c == axis) continue;
    const int at = axis == D - 1 ? k : j;
    const long s = block.stride[axis];
    const auto& [lower, upper] = reflections_[axis];
    if (at == 0 && lower.here) mirror_onto(c, lower, row, -s);
    if (at == block.count[axis] - 1 && upper.here) mirror_onto(c, upper, row, s);
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
