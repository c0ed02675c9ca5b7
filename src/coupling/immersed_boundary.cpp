#include "coupling/immersed_boundary.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

constexpr double mobility_floor = 0.02;  // of that of a single cell

}  // namespace

template <int D>
ImmersedBoundary<D>::ImmersedBoundary(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel,
                                      const Reflections& sides, double marker_spacing)
    : grid_(grid),
      kernel_(kernel),
      sides_(sides),
      spacing_(marker_spacing * grid.mesh().h.minCoeff()),
      markers_(cloth, spacing_),
      stencils_(static_cast<std::size_t>(markers_.count())),
      unit_(cloth.position.size(), Vec<D>::Ones()) {
  local_.reserve(stencils_.size());
  for (auto& o : ones_) o = grid.make_field();
}

/// Weights along one axis. Points beyond a side are folded back onto the point they mirror.
template <int D>
typename ImmersedBoundary<D>::Line ImmersedBoundary<D>::line(double x, int axis,
                                                             bool on_faces) const {
  const auto& mesh = grid_.mesh();
  const int n = mesh.cells[axis];
  const double cells = (x - mesh.lower[axis]) / mesh.h[axis] - (on_faces ? 0.0 : 0.5);
  Line l{static_cast<int>(std::floor(cells)) - 1, kernel_weights(kernel_, cells)};
  if (mesh.periodic[axis]) {
    l.start = (l.start % n + n) % n;
    return l;
  }
  if (l.start >= 0 && l.start + kernel_points <= n) return l;
  Line folded{std::clamp(l.start, 0, n - kernel_points), {}};
  for (int m = 0; m < kernel_points; ++m) {
    int i = l.start + m;
    double w = l.weight[m];
    const int side = i < 0 ? 0 : 1;
    const int last = on_faces ? n : n - 1;  // faces 0 and n lie on the sides
    if (i < 0 || i > last) {
      i = side == 0 ? (on_faces ? -i : -1 - i) : (on_faces ? 2 * n - i : 2 * n - 1 - i);
      w *= on_faces || sides_[axis][side] == Reflection::odd ? -1.0 : 1.0;
    }
    const int at = i - folded.start;
    if (at >= 0 && at < kernel_points) folded.weight[at] += w;
  }
  return folded;
}

template <int D>
bool ImmersedBoundary<D>::reaches_block(const Stencil& s) const {
  const auto& block = grid_.block();
  for (int d = 1; d < D; ++d) {
    if (grid_.ranks()[d] == 1) continue;
    bool any = false;
    for (const Line* l : {&s.face[d], &s.centre[d]})
      for (int m = 0; m < kernel_points; ++m) {
        const int n = grid_.mesh().cells[d];
        const int i = (l->start + m) % n - block.offset[d];
        any = any || (i >= 0 && i < block.count[d]);
      }
    if (!any) return false;
  }
  return true;
}

template <int D>
void ImmersedBoundary<D>::place(const std::vector<Vec<D>>& X) {
  local_.clear();
  for (int m = 0; m < markers_.count(); ++m) {
    const Vec<D> x = markers_.position(m, X);
    auto& s = stencils_[static_cast<std::size_t>(m)];
    for (int d = 0; d < D; ++d) {
      s.face[d] = line(x[d], d, true);
      s.centre[d] = line(x[d], d, false);
    }
    if (reaches_block(s)) local_.push_back(m);
  }
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
void ImmersedBoundary<D>::spread(const std::vector<Vec<D>>& G, Components& f) const {
  const double per_volume = 1 / grid_.mesh().cell_volume();
  const int n = grid_.mesh().cells[0];
  for (const int m : local_) {
    Vec<D> force = Vec<D>::Zero();
    for (int c = 0; c < Markers<D>::corners; ++c)
      force += markers_.share(m)[c] * G[markers_.nodes(m)[c]];
    force *= per_volume;
    const auto& s = stencils_[static_cast<std::size_t>(m)];
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

/// U_i = sum over its markers of share times value(component, memory position).
template <int D>
template <class Value>
void ImmersedBoundary<D>::gather(Value&& value, std::vector<Vec<D>>& U) const {
  const int n = grid_.mesh().cells[0];
  std::fill(U.begin(), U.end(), Vec<D>::Zero());
  for (const int m : local_) {
    const auto& s = stencils_[static_cast<std::size_t>(m)];
    Vec<D> u;
    for (int c = 0; c < D; ++c) {
      const Line& x = s.along(0, c);
      Weights sum{};  // over the rows, for each place along x
      if (x.start + kernel_points <= n)
        for_rows(s, c, [&](long row, double weight) {
          for (int i = 0; i < kernel_points; ++i) sum[i] += weight * value(c, row + x.start + i);
        });
      else
        for_rows(s, c, [&](long row, double weight) {
          for (int i = 0; i < kernel_points; ++i)
            sum[i] += weight * value(c, row + (x.start + i) % n);
        });
      u[c] = 0;
      for (int i = 0; i < kernel_points; ++i) u[c] += x.weight[i] * sum[i];
    }
    for (int c = 0; c < Markers<D>::corners; ++c)
      U[markers_.nodes(m)[c]] += markers_.share(m)[c] * u;
  }
  grid_.parallel().sum(std::span<double>(U.front().data(), U.size() * D));
}

template <int D>
void ImmersedBoundary<D>::interpolate(const Components& u, std::vector<Vec<D>>& U) const {
  std::array<const double*, D> field;
  for (int d = 0; d < D; ++d) field[d] = u[d].data();
  gather([&](int c, long p) { return field[c][p]; }, U);
}

template <int D>
void ImmersedBoundary<D>::mobility(const Openings<D>& openings, double density,
                                   std::vector<Vec<D>>& mobility) {
  for (auto& o : ones_) o.fill(0);
  spread(unit_, ones_);
  gather([&](int c, long p) { return ones_[c][p] * openings.open[c][p]; }, mobility);
  const double floor = mobility_floor / (density * grid_.mesh().cell_volume());
  for (auto& d : mobility) d = (d / density).cwiseMax(floor);
}

template class ImmersedBoundary<2>;
template class ImmersedBoundary<3>;

}  // namespace washtub
