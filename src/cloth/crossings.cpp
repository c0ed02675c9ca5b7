#include "cloth/crossings.hpp"

#include <algorithm>
#include <cmath>

#include "cloth/boxes.hpp"

namespace washtub {
namespace {

/// Degenerate contact: volumes (areas) below this share of the product of the lengths are none.
constexpr double rounding = 1e-10;

/// N nodes of one piece and their places.
template <int D, int N>
struct Element {
  std::array<int, N> node;
  std::array<Vec<D>, N> x;
  int piece;

  BoundingBox<D> box() const {
    BoundingBox<D> b{x[0], x[0]};
    for (const auto& p : x) b.lower = b.lower.cwiseMin(p), b.upper = b.upper.cwiseMax(p);
    return b;
  }
};

/// Edges, and the faces they may pass through: triangles, in 2-D the edges themselves.
template <int D>
struct Parts {
  std::vector<Element<D, 2>> edges;
  std::vector<Element<D, D>> faces;
};

template <int D>
class Collect {
 public:
  explicit Collect(const Cloth<D>& cloth) : cloth_(cloth) {
    for (const auto& group : cloth.groups)
      for (int p = 0; p < group.pieces; ++p) add_piece(group, p);
  }
  Parts<D> take() { return std::move(found_); }

 private:
  using Corners = std::array<std::array<int, 2>, D>;

  void add_piece(const ClothGroup<D>& group, int piece) {
    const auto& sheet = group.sheet;
    for (int j = 0; j < sheet.extent[1]; ++j)
      for (int i = 0; i < sheet.extent[0]; ++i) {
        const bool r = i < sheet.intervals(0) && sheet.extent[0] > 1;
        const bool s = j < sheet.intervals(1) && sheet.extent[1] > 1;
        if (r) found_.edges.push_back(element<2>(group, piece, {{{i, j}, {i + 1, j}}}));
        if (s) found_.edges.push_back(element<2>(group, piece, {{{i, j}, {i, j + 1}}}));
        if constexpr (D == 3) {
          if (r && s) add_quad(group, piece, i, j);
        } else {
          if (s) found_.faces.push_back(found_.edges.back());
        }
      }
  }

  void add_quad(const ClothGroup<3>& group, int piece, int i, int j) {
    using Triangle = std::array<std::array<int, 2>, 3>;
    const bool even = (i + j) % 2 == 0;
    const Triangle lower = even ? Triangle{{{i, j}, {i + 1, j}, {i + 1, j + 1}}}
                                : Triangle{{{i, j}, {i + 1, j}, {i, j + 1}}};
    const Triangle upper = even ? Triangle{{{i, j}, {i + 1, j + 1}, {i, j + 1}}}
                                : Triangle{{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}};
    for (const auto& corners : {lower, upper})
      found_.faces.push_back(element<3>(group, piece, corners));
  }

  template <int N>
  Element<D, N> element(const ClothGroup<D>& group, int piece,
                        const std::array<std::array<int, 2>, N>& corners) const {
    Element<D, N> e;
    e.piece = group.first_piece + piece;
    for (std::size_t n = 0; n < N; ++n) {
      const Image<D> image = group.sheet.image(corners[n][0], corners[n][1]);
      e.node[n] = group.node(piece, image.node);
      e.x[n] = cloth_.position[static_cast<std::size_t>(e.node[n])] + image.shift;
    }
    return e;
  }

  const Cloth<D>& cloth_;
  Parts<D> found_;
};

/// Whether a and b are on opposite sides of something, neither within `touching` of it.
bool opposite(double a, double b, double touching) {
  return (a > touching && b < -touching) || (a < -touching && b > touching);
}

double area(const Vec<2>& a, const Vec<2>& b) { return a[0] * b[1] - a[1] * b[0]; }

bool passes(const Element<2, 2>& edge, const Element<2, 2>& face, const Vec<2>& shift) {
  const Vec<2> p = edge.x[0] + shift, q = edge.x[1] + shift;
  const Vec<2>&a = face.x[0], &b = face.x[1];
  const double touching = rounding * (q - p).norm() * (b - a).norm();
  return opposite(area(b - a, p - a), area(b - a, q - a), touching) &&
         opposite(area(q - p, a - p), area(q - p, b - p), touching);
}

/// The ends on opposite sides of the triangle's plane, and the line through them on the same side
/// of all its edges.
bool passes(const Element<3, 2>& edge, const Element<3, 3>& face, const Vec<3>& shift) {
  const Vec<3> p = edge.x[0] + shift, along = edge.x[1] - edge.x[0];
  const Vec<3> a = face.x[0] - p, b = face.x[1] - p, c = face.x[2] - p;
  const Vec<3> normal = (b - a).cross(c - a);
  const double size = std::max((b - a).norm(), (c - a).norm());
  const double touching = rounding * along.norm() * size * size;
  if (!opposite(-normal.dot(a), normal.dot(along - a), touching)) return false;
  const double u = along.dot(a.cross(b)), v = along.dot(b.cross(c)), w = along.dot(c.cross(a));
  return (u > touching && v > touching && w > touching) ||
         (u < -touching && v < -touching && w < -touching);
}

template <int N, int M>
bool touch(const std::array<int, N>& a, const std::array<int, M>& b) {
  return std::any_of(a.begin(), a.end(),
                     [&](int n) { return std::find(b.begin(), b.end(), n) != b.end(); });
}

}  // namespace

template <int D>
Crossings find_crossings(const Cloth<D>& cloth, const Mesh<D>& mesh) {
  for (const auto& x : cloth.position)
    if (!x.allFinite()) return {};
  const Parts<D> elements = Collect<D>(cloth).take();
  std::vector<BoundingBox<D>> faces;
  for (const auto& face : elements.faces) faces.push_back(face.box());
  double longest = 0;
  for (const auto& edge : elements.edges) longest = std::max(longest, edge.box().size().maxCoeff());
  const BoxLists<D> near(faces, mesh, longest);
  Crossings found;
  found.edges = static_cast<long>(elements.edges.size());
  for (const auto& edge : elements.edges) {
    bool others = false, own = false;
    near.for_overlaps(edge.box(), [&](std::size_t f, const Vec<D>& shift) {
      const auto& face = elements.faces[f];
      bool& crosses = face.piece == edge.piece ? own : others;
      if (!crosses && !touch<2, D>(edge.node, face.node)) crosses = passes(edge, face, shift);
    });
    found.others += others;
    found.own += own;
  }
  return found;
}

template Crossings find_crossings<2>(const Cloth<2>&, const Mesh<2>&);
template Crossings find_crossings<3>(const Cloth<3>&, const Mesh<3>&);

}  // namespace washtub
