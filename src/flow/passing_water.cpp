#include "flow/passing_water.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr double least_speed = 0.1;  // of the convective condition, over the fastest inflow

}  // namespace

template <int D>
PassingWater<D>::PassingWater(const Grid<D>& grid, const SidePairs<D>& sides)
    : grid_(grid), sides_(sides) {
  bool way_out = false;
  double gain = 0, gross = 0;
  for (int a = 0; a < D; ++a)
    for (int s = 0; s < 2; ++s) {
      const auto& side = sides[a][s];
      way_out |= lets_out(side.kind);
      if (side.kind != Kind::inflow) continue;
      any_ = true;
      const double flux = side.velocity[a] * grid.mesh().size().prod() / grid.mesh().size()[a];
      gain += s == 0 ? flux : -flux;
      gross += std::abs(flux);
      fastest_inflow_ = std::max(fastest_inflow_, side.velocity.norm());
    }
  any_ |= way_out;
  if (!way_out && std::abs(gain) > 1e-12 * gross)
    throw InputError(
        "water enters through an inflow side and no side lets it out; try an outflow side");
}

/// From a cell at the side to its face on the side, to the opposite face, and the area with sign +
/// where water that leaves has positive velocity.
template <int D>
typename PassingWater<D>::Step PassingWater<D>::step(int axis, int side) const {
  const long t = grid_.block().stride[axis];
  const double area = grid_.mesh().cell_volume() / grid_.mesh().h[axis];
  return side == 0 ? Step{0, t, -area} : Step{t, 0, area};
}

/// Calls visit(p) with the memory position of every cell of this rank that touches the side.
template <int D>
template <class Visit>
void PassingWater<D>::for_cells(int axis, int side, Visit&& visit) const {
  const auto& block = grid_.block();
  Index<D> first{}, last = block.count;
  if (side == 1) first[axis] = block.count[axis] - 1;
  last[axis] = first[axis] + 1;
  const int j0 = D == 3 ? first[1] : 0, j1 = D == 3 ? last[1] : 1;
  for (int k = first[D - 1]; k < last[D - 1]; ++k)
    for (int j = j0; j < j1; ++j) {
      const long row = block.row(j, k);
      for (int i = first[0]; i < last[0]; ++i) visit(row + i);
    }
}

/// Calls visit(axis, side, kind) for the sides that this rank's block has.
template <int D>
template <class Visit>
void PassingWater<D>::for_sides(Visit&& visit) const {
  for (int a = 0; a < D; ++a)
    for (int s = 0; s < 2; ++s)
      if (grid_.at_side(a, s)) visit(a, s, sides_[a][s].kind);
}

template <int D>
void PassingWater<D>::enter(int axis, int side, double* u, const float* open, Sums& sums) const {
  const Step at = step(axis, side);
  const double velocity = sides_[axis][side].velocity[axis];
  for_cells(axis, side, [&](long p) {
    u[p + at.face] = open[p + at.inside] > 0 ? velocity : 0.0;
    sums.flux += at.out * u[p + at.face];
  });
}

/// Normal velocities approach those one cell inside by `share` of the difference.
template <int D>
void PassingWater<D>::leave(int axis, int side, double* u, const float* open, double share,
                            Sums& sums) const {
  const Step at = step(axis, side);
  const double outflow = sides_[axis][side].kind == Kind::outflow ? 1 : 0;
  for_cells(axis, side, [&](long p) {
    const double on = open[p + at.inside] > 0 ? 1.0 : 0.0;
    u[p + at.face] = on * (u[p + at.face] + share * (u[p + at.inside] - u[p + at.face]));
    sums.flux += at.out * u[p + at.face];
    sums.open_area += on * std::abs(at.out);
    sums.outflow += outflow * at.out * u[p + at.face];
    sums.outflow_area += outflow * on * std::abs(at.out);
  });
}

template <int D>
void PassingWater<D>::drag_ghosts(int axis, int side, const std::array<double*, D>& u,
                                  double share) const {
  const long ghost = (side == 0 ? -1 : 1) * grid_.block().stride[axis];
  for (int c = 0; c < D; ++c)
    if (c != axis)
      for_cells(axis, side,
                [&](long p) { u[c][p + ghost] += share * (u[c][p] - u[c][p + ghost]); });
}

template <int D>
void PassingWater<D>::advance(const std::array<double*, D>& u,
                              const std::array<const float*, D>& open, double dt, double speed) {
  if (!any_) return;
  const double least = least_speed * (fastest_inflow_ > 0 ? fastest_inflow_ : speed);
  const double c = std::max(mean_outflow_, least);
  Sums sums;
  for_sides([&](int axis, int side, Kind kind) {
    const double share = std::min(1.0, c * dt / grid_.mesh().h[axis]);
    if (kind == Kind::inflow) enter(axis, side, u[axis], open[axis], sums);
    if (lets_out(kind)) leave(axis, side, u[axis], open[axis], share, sums);
    if (kind == Kind::outflow) drag_ghosts(axis, side, u, share);
  });
  std::array<double, 4> all{sums.flux, sums.open_area, sums.outflow, sums.outflow_area};
  grid_.parallel().sum(std::span<double>(all));
  const auto [flux, open_area, outflow, outflow_area] = all;
  const double surplus = open_area > 0 ? flux / open_area : 0;
  for_sides([&](int axis, int side, Kind kind) {
    if (!lets_out(kind)) return;
    const Step at = step(axis, side);
    const double less = at.out > 0 ? surplus : -surplus;
    for_cells(axis, side,
              [&](long p) { u[axis][p + at.face] -= open[axis][p + at.inside] > 0 ? less : 0.0; });
  });
  mean_outflow_ = outflow_area > 0 ? outflow / outflow_area - surplus : 0;
}

template class PassingWater<2>;
template class PassingWater<3>;

}  // namespace washtub
