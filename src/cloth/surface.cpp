#include "cloth/surface.hpp"

#include <cmath>
#include <map>

namespace washtub {
namespace {

/// Adds one piece after the other to a surface.
template <int D>
class Builder {
 public:
  Builder(const Cloth<D>& cloth, ClothSurface<D>& out) : cloth_(cloth), out_(out) {
    for (const auto& g : cloth.groups)
      for (int p = 0; p < g.pieces; ++p)
        for (int n = 0; n < g.sheet.nodes(); ++n)
          add_point(g, p, n, Vec<D>::Zero(), {n % g.sheet.extent[0], n / g.sheet.extent[0]});
    for (const auto& g : cloth.groups)
      for (int p = 0; p < g.pieces; ++p) add_piece(g, p);
    out_.first_face.push_back(static_cast<int>(out_.faces.size()));
    out_.along = out_.edges.size();
    out_.edges.insert(out_.edges.end(), diagonals_.begin(), diagonals_.end());
  }

 private:
  using Place = std::array<int, 2>;  ///< (i, j) along r and s

  int add_point(const ClothGroup<D>& g, int piece, int local, const Vec<D>& shift, Place at) {
    out_.node.push_back(g.node(piece, local));
    out_.shift.push_back(shift);
    out_.piece.push_back(g.first_piece + piece);
    out_.rest.emplace_back(at[0] * g.sheet.spacing[0], at[1] * g.sheet.spacing[1]);
    return out_.points() - 1;
  }

  /// The point of node (i, j), or of its image where that lies across a seam.
  int point(const ClothGroup<D>& g, int piece, Place at) {
    const Image<D> image = g.sheet.image(at[0], at[1]);
    if (image.shift.isZero(0)) return g.node(piece, image.node);
    const auto [found, isnew] = images_.try_emplace({g.first_piece + piece, at[0], at[1]}, 0);
    if (isnew) found->second = add_point(g, piece, image.node, image.shift, at);
    return found->second;
  }

  void add_piece(const ClothGroup<D>& g, int piece) {
    const auto& sheet = g.sheet;
    out_.first_face.push_back(static_cast<int>(out_.faces.size()));
    out_.group.push_back(static_cast<int>(&g - cloth_.groups.data()));
    out_.around.push_back(Vec<2>::Zero());
    for (int d = 0; d < 2; ++d)
      if (sheet.closed[d]) out_.around.back()[d] = sheet.extent[d] * sheet.spacing[d];
    out_.area.push_back(D == 3 ? 0.5 * sheet.spacing[0] * sheet.spacing[1] : sheet.spacing[1]);
    const auto add_edge = [&](Place a, Place b) {
      out_.edges.push_back({point(g, piece, a), point(g, piece, b)});
    };
    for (int j = 0; j < sheet.extent[1]; ++j)
      for (int i = 0; i < sheet.extent[0]; ++i) {
        const bool r = i < sheet.intervals(0) && sheet.extent[0] > 1;
        const bool s = j < sheet.intervals(1) && sheet.extent[1] > 1;
        if (r) add_edge({i, j}, {i + 1, j});
        if (s) add_edge({i, j}, {i, j + 1});
        if constexpr (D == 3) {
          if (r && s) add_quad(g, piece, i, j);
        } else {
          if (s) out_.faces.push_back(out_.edges.back());
        }
      }
  }

  void add_quad(const ClothGroup<3>& g, int piece, int i, int j) {
    const int a = point(g, piece, {i, j}), b = point(g, piece, {i + 1, j});
    const int c = point(g, piece, {i, j + 1}), d = point(g, piece, {i + 1, j + 1});
    if ((i + j) % 2 == 0) {
      out_.faces.insert(out_.faces.end(), {{a, b, d}, {a, d, c}});
      diagonals_.push_back({a, d});
    } else {
      out_.faces.insert(out_.faces.end(), {{a, b, c}, {b, d, c}});
      diagonals_.push_back({b, c});
    }
  }

  const Cloth<D>& cloth_;
  ClothSurface<D>& out_;
  std::vector<std::array<int, 2>> diagonals_;
  std::map<std::array<int, 3>, int> images_;  ///< points of (piece, i, j)
};

}  // namespace

template <int D>
ClothSurface<D>::ClothSurface(const Cloth<D>& cloth) {
  Builder<D>(cloth, *this);
}

template <int D>
bool ClothSurface<D>::place(std::span<const Vec<D>> X, std::vector<Vec<D>>& x) const {
  x.resize(node.size());
  bool finite = true;
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = X[node[i]] + shift[i];
    finite = finite && x[i].allFinite();
  }
  return finite;
}

namespace {

/// The shorter way round a closed direction.
Vec<2> shorter(Vec<2> way, const Vec<2>& around) {
  for (int d = 0; d < 2; ++d)
    if (around[d] > 0) way[d] -= around[d] * std::round(way[d] / around[d]);
  return way;
}

}  // namespace

template <int D>
double ClothSurface<D>::rest_distance(int piece, const Vec<2>& a, const Vec<2>& b) const {
  return shorter(a - b, around[piece]).norm();
}

template <int D>
std::array<Vec<2>, D> ClothSurface<D>::rest_of(int face, int piece) const {
  std::array<Vec<2>, D> corners;
  for (std::size_t k = 0; k < D; ++k)
    corners[k] =
        rest[faces[face][0]] + shorter(rest[faces[face][k]] - rest[faces[face][0]], around[piece]);
  return corners;
}

template struct ClothSurface<2>;
template struct ClothSurface<3>;

}  // namespace washtub
