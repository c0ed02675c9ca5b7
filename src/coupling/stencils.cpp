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
      points_(points_of(kernel)),
      markers_(cloth, spacing * grid.mesh().h.minCoeff()) {
  const auto count = static_cast<std::size_t>(markers_.count());
  local_.reserve(count);
  places_.reserve(count);
  weights_.reserve(count);
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

/// On return `lines` are those of a marker at x; false if they are not on this rank, and then they
/// are complete only where sides move.
template <int D>
bool Stencils<D>::find_lines(const Vec<D>& x, Lines& lines) const {
  const auto& mesh = grid_.mesh();
  bool here = true;
  for (int d = D - 1; d >= 0 && (here || moving_sides_); --d) {
    double cells = (x[d] - mesh.lower[d]) / mesh.h[d];
    if (mesh.periodic[d]) cells -= mesh.cells[d] * std::floor(cells / mesh.cells[d]);
    const KernelPair pair = kernel_pair(kernel_, cells);
    lines[d] = {fold(pair.centre, d, false), fold(pair.face, d, true)};
    here = here && (reaches_block(lines[d][0], d) || reaches_block(lines[d][1], d));
  }
  return here;
}

/// Points beyond a side are folded back onto the point they mirror, with what is left of the side's
/// own velocity in `given`.
template <int D>
typename Stencils<D>::Line Stencils<D>::fold(const KernelLine& l, int axis, bool on_faces) const {
  const int n = grid_.mesh().cells[axis];
  const int width = axis == 0 ? kernel_points : points_;
  if (grid_.mesh().periodic[axis]) return {{(l.start % n + n) % n, l.weight}};
  if (l.start >= 0 && l.start + width <= n) return {l};
  Line folded{{std::clamp(l.start, 0, n - width), {}}};
  for (int m = 0; m < points_; ++m) {
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
    const int at = i - folded.kernel.start;
    if (at >= 0 && at < width) folded.kernel.weight[at] += w;
  }
  return folded;
}

template <int D>
bool Stencils<D>::reaches_block(const Line& l, int axis) const {
  if (grid_.ranks()[axis] == 1) return true;
  const auto& block = grid_.block();
  for (int m = 0; m < points_; ++m) {
    const int i = (l.kernel.start + m) % grid_.mesh().cells[axis] - block.offset[axis];
    if (i >= 0 && i < block.count[axis]) return true;
  }
  return false;
}

template <int D>
void Stencils<D>::keep(int marker, const Lines& lines) {
  const auto& block = grid_.block();
  local_.push_back(marker);
  auto& place = places_.emplace_back();
  auto& weights = weights_.emplace_back();
  for (int on_faces = 0; on_faces < 2; ++on_faces) {
    place.start[on_faces] = lines[0][on_faces].kernel.start;
    weights[0][on_faces] = lines[0][on_faces].kernel.weight;
    for (int d = 1; d < D; ++d) {
      const auto& l = lines[d][on_faces].kernel;
      auto& offset = place.offset[d - 1][on_faces];
      auto& weight = weights[d][on_faces];
      const int n = grid_.mesh().cells[d], count = block.count[d],
                start = l.start - block.offset[d];
      const long first = d == D - 1 ? block.row(0, 0) : 0, stride = block.stride[d];
      weight = l.weight;
      if (start >= 0 && start + kernel_points <= count) {
        for (int m = 0; m < kernel_points; ++m) offset[m] = first + stride * (start + m);
        continue;
      }
      for (int m = 0; m < kernel_points; ++m) {
        const int i = l.start + m < n ? start + m : start + m - n;
        offset[m] = first + stride * std::clamp(i, 0, count - 1);
        if (i < 0 || i >= count) weight[m] = 0;
      }
    }
  }
}

/// What the sides' own velocities add to that of a marker, taking one axis after the other.
template <int D>
Vec<D> Stencils<D>::drag(const Lines& lines) const {
  Vec<D> u = Vec<D>::Zero();
  for (int c = 0; c < D; ++c)
    for (int d = 0; d < D; ++d) {
      const Line& l = lines[d][d == c];
      double sum = 0;
      for (const double w : l.kernel.weight) sum += w;
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
  places_.clear();
  weights_.clear();
  given_.clear();
  Lines lines;
  for (int m = 0; m < markers_.count(); ++m) {
    const Vec<D> x = markers_.position(m, X);
    if (!x.allFinite())
      throw RunError(
          "the place of the cloth is no longer finite; try a smaller time.step, or coupling.scheme "
          "= \"implicit\"");
    keep_off_open_sides(x, m);
    if (find_lines(x, lines)) keep(m, lines);
    if (!moving_sides_) continue;
    const Vec<D> u = drag(lines);
    if (u != Vec<D>::Zero()) given_.emplace_back(m, u);
  }
}

template class Stencils<2>;
template class Stencils<3>;

}  // namespace washtub
