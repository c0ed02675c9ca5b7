#include "coupling/stencils.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr double reach = 2;  // half width of the widest delta function, in cells

template <int D>
Reflection reflection(const Side<D>& side) {
  using Kind = typename Side<D>::Kind;
  switch (side.kind) {
    case Kind::wall:
    case Kind::inflow:
      return Reflection::odd;
    case Kind::slip:
      return Reflection::even;
    case Kind::periodic:
      return Reflection::none;
    default:
      return Reflection::open;
  }
}

}  // namespace

template <int D>
Stencils<D>::Stencils(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel,
                      const SidePairs<D>& sides, double spacing)
    : grid_(grid),
      cloth_(cloth),
      kernel_(kernel),
      markers_(cloth, spacing * grid.mesh().h.minCoeff()),
      stencils_(static_cast<std::size_t>(markers_.count())) {
  local_.reserve(stencils_.size());
  for (int d = 0; d < D; ++d)
    for (int side = 0; side < 2; ++side) {
      const auto& s = sides[d][side];
      sides_[d][side] = grid.mesh().periodic[d] ? Reflection::none : reflection(s);
      Vec<D> u = Vec<D>::Zero();
      if (sides_[d][side] == Reflection::odd) u = s.velocity;
      if (s.kind == Side<D>::Kind::wall) u[d] = 0;
      side_velocity_[d][side] = u;
      moving_sides_ = moving_sides_ || u.norm() > 0;
    }
}

/// Weights along one axis. Points beyond a side are folded back onto the point they mirror, with
/// what is left of the side's own velocity in `given`.
template <int D>
typename Stencils<D>::Line Stencils<D>::line(double x, int axis, bool on_faces) const {
  const auto& mesh = grid_.mesh();
  const int n = mesh.cells[axis];
  double cells = (x - mesh.lower[axis]) / mesh.h[axis] - (on_faces ? 0.0 : 0.5);
  if (mesh.periodic[axis]) cells -= n * std::floor(cells / n);
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
    const bool odd = on_faces || sides_[axis][side] == Reflection::odd;
    if (i < 0 || i > last) {
      i = side == 0 ? (on_faces ? -i : -1 - i) : (on_faces ? 2 * n - i : 2 * n - 1 - i);
      if (odd) folded.given += 2 * w, folded.side = side;
      if (odd) w = -w;
    }
    if (i == n) folded.given += w, folded.side = 1;
    const int at = i - folded.start;
    if (at >= 0 && at < kernel_points) folded.weight[at] += w;
  }
  return folded;
}

template <int D>
bool Stencils<D>::reaches_block(const Stencil& s) const {
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

/// What the sides' own velocities add to that of a marker, taking one axis after the other.
template <int D>
Vec<D> Stencils<D>::drag(const Stencil& s) const {
  Vec<D> u = Vec<D>::Zero();
  for (int c = 0; c < D; ++c)
    for (int d = 0; d < D; ++d) {
      const Line& l = s.along(d, c);
      double sum = 0;
      for (const double w : l.weight) sum += w;
      u[c] = sum * u[c] + l.given * side_velocity_[d][l.side][c];
    }
  return u;
}

template <int D>
void Stencils<D>::keep_off_open_sides(const Vec<D>& x, int marker) const {
  const auto& mesh = grid_.mesh();
  for (int d = 0; d < D; ++d)
    for (int side = 0; side < 2; ++side) {
      if (sides_[d][side] != Reflection::open) continue;
      const double cells = (x[d] - mesh.lower[d]) / mesh.h[d];
      if ((side == 0 ? cells : mesh.cells[d] - cells) >= reach) continue;
      const int node = markers_.nodes(marker)[0];
      int piece = 0;
      for (const auto& g : cloth_.groups)
        if (node >= g.first_node) piece = g.first_piece + (node - g.first_node) / g.sheet.nodes();
      throw RunError("piece " + std::to_string(piece + 1) + " is less than two cells from the " +
                     (side == 0 ? "lower " : "upper ") + "xyz"[d] +
                     " side, where the water leaves the box; try a larger domain.size or an "
                     "earlier time.end");
    }
}

template <int D>
void Stencils<D>::place(const std::vector<Vec<D>>& X) {
  local_.clear();
  given_.clear();
  for (int m = 0; m < markers_.count(); ++m) {
    const Vec<D> x = markers_.position(m, X);
    if (!x.allFinite())
      throw RunError(
          "the place of the cloth is no longer finite; try a smaller time.step, or coupling.scheme "
          "= \"implicit\"");
    keep_off_open_sides(x, m);
    auto& s = stencils_[m];
    for (int d = 0; d < D; ++d) {
      s.face[d] = line(x[d], d, true);
      s.centre[d] = line(x[d], d, false);
    }
    if (reaches_block(s)) local_.push_back(m);
    if (!moving_sides_) continue;
    const Vec<D> u = drag(s);
    if (u != Vec<D>::Zero()) given_.emplace_back(m, u);
  }
}

template class Stencils<2>;
template class Stencils<3>;

}  // namespace washtub
