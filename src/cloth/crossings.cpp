#include "cloth/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "cloth/boxes.hpp"
#include "cloth/surface.hpp"

namespace washtub {
namespace {

/// Degenerate contact: volumes (areas) below this share of the product of the lengths are none.
constexpr double rounding = 1e-10;

/// The places of N points of a surface.
template <int D, std::size_t N>
using Corners = std::array<Vec<D>, N>;

template <int D, std::size_t N>
Corners<D, N> corners(const std::array<int, N>& points, const std::vector<Vec<D>>& x) {
  Corners<D, N> c;
  for (std::size_t n = 0; n < N; ++n) c[n] = x[static_cast<std::size_t>(points[n])];
  return c;
}

/// Whether a and b are on opposite sides of something, neither within `touching` of it.
bool opposite(double a, double b, double touching) {
  return (a > touching && b < -touching) || (a < -touching && b > touching);
}

double area(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

bool passes(const Corners<2, 2>& edge, const Corners<2, 2>& face, const Vec<2>& shift) {
  const Vec<2> p = edge[0] + shift, q = edge[1] + shift;
  const auto& [a, b] = face;
  const double touching = rounding * (q - p).norm() * (b - a).norm();
  return opposite(area(b - a, p - a), area(b - a, q - a), touching) &&
         opposite(area(q - p, a - p), area(q - p, b - p), touching);
}

/// The ends on opposite sides of the triangle's plane, and the line through them on the same side
/// of all its edges.
bool passes(const Corners<3, 2>& edge, const Corners<3, 3>& face, const Vec<3>& shift) {
  const Vec<3> p = edge[0] + shift, along = edge[1] - edge[0];
  const Vec<3> a = face[0] - p, b = face[1] - p, c = face[2] - p;
  const Vec<3> normal = (b - a).cross(c - a);
  const double size = std::max((b - a).norm(), (c - a).norm());
  const double touching = rounding * along.norm() * size * size;
  if (!opposite(-normal.dot(a), normal.dot(along - a), touching)) return false;
  const double u = along.dot(a.cross(b)), v = along.dot(b.cross(c)), w = along.dot(c.cross(a));
  return (u > touching && v > touching && w > touching) ||
         (u < -touching && v < -touching && w < -touching);
}

/// Whether an edge and a face have a node in common.
template <int D>
bool touch(const ClothSurface<D>& surface, const typename ClothSurface<D>::Edge& edge,
           const typename ClothSurface<D>::Face& face) {
  const auto node = [&](int point) { return surface.node[static_cast<std::size_t>(point)]; };
  return std::any_of(edge.begin(), edge.end(), [&](int a) {
    return std::any_of(face.begin(), face.end(), [&](int b) { return node(a) == node(b); });
  });
}

}  // namespace

template <int D>
Crossings find_crossings(const Cloth<D>& cloth, const Mesh<D>& mesh) {
  const ClothSurface<D> surface(cloth);
  std::vector<Vec<D>> x;
  if (!surface.place(cloth.position, x)) return {};
  std::vector<BoundingBox<D>> faces;
  for (const auto& face : surface.faces) faces.push_back(box_about<D>(corners<D>(face, x)));
  double longest = 0;
  for (std::size_t e = 0; e < surface.along; ++e)
    longest = std::max(longest, box_about<D>(corners<D>(surface.edges[e], x)).size().maxCoeff());
  const BoxLists<D> near(faces, mesh, longest);
  Crossings found;
  found.edges = static_cast<long>(surface.along);
  for (std::size_t e = 0; e < surface.along; ++e) {
    bool others = false, own = false;
    const auto& edge = surface.edges[e];
    const auto ends = corners<D>(edge, x);
    near.for_overlaps(box_about<D>(ends), [&](std::size_t f, const Vec<D>& shift) {
      const auto& face = surface.faces[f];
      const auto piece = [&](int point) { return surface.piece[static_cast<std::size_t>(point)]; };
      bool& crosses = piece(face[0]) == piece(edge[0]) ? own : others;
      if (crosses || touch<D>(surface, edge, face)) return;
      crosses = passes(ends, corners<D>(face, x), shift);
      const int a = piece(edge[0]), b = piece(face[0]);
      if (crosses) found.pieces.insert({std::min(a, b), std::max(a, b)});
    });
    found.others += others;
    found.own += own;
  }
  return found;
}

template Crossings find_crossings<2>(const Cloth<2>&, const Mesh<2>&);
template Crossings find_crossings<3>(const Cloth<3>&, const Mesh<3>&);

}  // namespace washtub
