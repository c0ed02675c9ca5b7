#include "coupling/immersed_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

constexpr double mobility_floor = 0.02;  // of that of a single cell

}  // namespace

template <int D>
ImmersedBoundary<D>::ImmersedBoundary(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel,
                                      const SidePairs<D>& sides, double marker_spacing)
    : grid_(grid),
      stencils_(grid, cloth, kernel, sides, marker_spacing),
      unit_(cloth.position.size(), Vec<D>::Ones()) {
  for (auto& o : ones_) o = grid.make_field();
}

/// The grid lines of `l` along an axis other than x that run through this rank.
template <int D>
typename ImmersedBoundary<D>::OwnLines ImmersedBoundary<D>::own(const Line& l, int axis) const {
  const auto& block = grid_.block();
  const int n = grid_.mesh().cells[axis];
  OwnLines lines;
  for (int m = 0; m < kernel_points; ++m) {
    int i = l.start + m;
    i = (i < n ? i : i - n) - block.offset[axis];
    if (i < 0 || i >= block.count[axis]) continue;
    lines.offset[lines.count] = block.stride[axis] * i;
    lines.weight[lines.count++] = l.weight[m];
  }
  return lines;
}

/// Calls visit(memory position of the row, weight) for the rows of a stencil that this rank owns.
template <int D>
template <class Visit>
void ImmersedBoundary<D>::for_rows(const Stencil& s, int component, Visit&& visit) const {
  const long first = grid_.block().row(0, 0);
  const OwnLines planes = own(s.along(D - 1, component), D - 1);
  if constexpr (D == 2) {
    for (int k = 0; k < planes.count; ++k) visit(first + planes.offset[k], planes.weight[k]);
  } else {
    const OwnLines rows = own(s.along(1, component), 1);
    for (int k = 0; k < planes.count; ++k)
      for (int j = 0; j < rows.count; ++j)
        visit(first + planes.offset[k] + rows.offset[j], planes.weight[k] * rows.weight[j]);
  }
}

template <int D>
void ImmersedBoundary<D>::spread(const std::vector<Vec<D>>& G, Components<D>& f) const {
  const double per_volume = 1 / grid_.mesh().cell_volume();
  const int n = grid_.mesh().cells[0];
  const auto& markers = stencils_.markers();
  for (const int m : stencils_.local()) {
    Vec<D> force = Vec<D>::Zero();
    for (int c = 0; c < Markers<D>::corners; ++c)
      force += markers.share(m)[c] * G[markers.nodes(m)[c]];
    force *= per_volume;
    const auto& s = stencils_[m];
    for (int c = 0; c < D; ++c) {
      const Line& x = s.along(0, c);
      double* field = f[c].data();
      Weights g = x.weight;
      for (double& w : g) w *= force[c];
      if (x.start + kernel_points <= n)
        for_rows(s, c, [&](long row, double weight) {
          double* q = field + row + x.start;
          for (int i = 0; i < kernel_points; ++i) q[i] += weight * g[i];
        });
      else
        for_rows(s, c, [&](long row, double weight) {
          for (int i = 0; i < kernel_points; ++i) field[row + (x.start + i) % n] += weight * g[i];
        });
    }
  }
}

/// U_i = sum over its markers of share times component(c)(memory position).
template <int D>
template <class Component>
void ImmersedBoundary<D>::gather(Component&& component, std::vector<Vec<D>>& U) const {
  const int n = grid_.mesh().cells[0];
  const auto& markers = stencils_.markers();
  std::fill(U.begin(), U.end(), Vec<D>::Zero());
  for (const int m : stencils_.local()) {
    const auto& s = stencils_[m];
    Vec<D> u;
    for (int c = 0; c < D; ++c) {
      const Line& x = s.along(0, c);
      const auto value = component(c);
      Weights sum{};  // over the rows, for each place along x
      if (x.start + kernel_points <= n)
        for_rows(s, c, [&](long row, double weight) {
          for (int i = 0; i < kernel_points; ++i) sum[i] += weight * value(row + x.start + i);
        });
      else
        for_rows(s, c, [&](long row, double weight) {
          for (int i = 0; i < kernel_points; ++i) sum[i] += weight * value(row + (x.start + i) % n);
        });
      u[c] = 0;
      for (int i = 0; i < kernel_points; ++i) u[c] += x.weight[i] * sum[i];
    }
    for (int c = 0; c < Markers<D>::corners; ++c) U[markers.nodes(m)[c]] += markers.share(m)[c] * u;
  }
  grid_.parallel().sum(std::span<double>(U.front().data(), U.size() * D));
}

template <int D>
void ImmersedBoundary<D>::interpolate(const Components<D>& u, std::vector<Vec<D>>& U) const {
  gather([&](int c) { return [field = u[c].data()](long p) { return field[p]; }; }, U);
  add_given(U);
}

template <int D>
void ImmersedBoundary<D>::interpolate(const ProvisionalVelocity<D>& u,
                                      std::vector<Vec<D>>& U) const {
  gather([&](int c) { return u.component(c); }, U);
  add_given(U);
}

/// What moving sides add.
template <int D>
void ImmersedBoundary<D>::add_given(std::vector<Vec<D>>& U) const {
  const auto& markers = stencils_.markers();
  for (const auto& [m, given] : stencils_.given())
    for (int c = 0; c < Markers<D>::corners; ++c)
      U[markers.nodes(m)[c]] += markers.share(m)[c] * given;
}

template <int D>
void ImmersedBoundary<D>::mobility(const Openings<D>& openings, double density,
                                   std::vector<Vec<D>>& mobility) {
  for (auto& o : ones_) o.fill(0);
  spread(unit_, ones_);
  gather(
      [&](int c) {
        return
            [one = ones_[c].data(), open = openings.open[c]](long p) { return one[p] * open[p]; };
      },
      mobility);
  const double floor = mobility_floor / (density * grid_.mesh().cell_volume());
  for (auto& d : mobility) d = (d / density).cwiseMax(floor);
}

template class ImmersedBoundary<2>;
template class ImmersedBoundary<3>;

}  // namespace washtub
