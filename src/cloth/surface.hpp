#pragma once
#include <array>
#include <span>
#include <vector>

#include "cloth/cloth.hpp"

namespace washtub {

/// The cloth as one surface of flat faces: triangles in space, segments in the plane. Each quad of
/// nodes is cut into two triangles, by diagonals that alternate from quad to quad.
///
/// The first points are the nodes; those beyond them are images of nodes across the seam of a sheet
/// that is closed with a period.
template <int D>
struct ClothSurface {
  using Face = std::array<int, D>;  ///< numbers of points
  using Edge = std::array<int, 2>;

  explicit ClothSurface(const Cloth<D>& cloth);

  std::vector<int> node;        ///< of each point
  std::vector<Vec<D>> shift;    ///< of each point from its node [m]
  std::vector<int> piece;       ///< of each point, among all pieces
  std::vector<Vec<2>> rest;     ///< (r, s) of each point in its piece [m]
  std::vector<Face> faces;      ///< those of a quad side by side
  std::vector<Edge> edges;      ///< each once; first those along r and s, then the diagonals
  std::size_t along = 0;        ///< edges along r and s
  std::vector<int> first_face;  ///< of each piece, and the end of the last
  std::vector<int> group;       ///< of each piece
  std::vector<Vec<2>> around;   ///< of each piece, along r and s if closed [m]; else 0
  std::vector<double> area;     ///< at rest, of each face of a piece [m^2]; in 2-D length [m]

  int points() const { return static_cast<int>(node.size()); }
  /// Distance at rest between two places (r, s) of a piece, the shorter way round [m].
  double rest_distance(int piece, const Vec<2>& a, const Vec<2>& b) const;
  /// (r, s) of the corners of a face [m], all on the same side of a seam.
  std::array<Vec<2>, D> rest_of(int face, int piece) const;
  int pieces() const { return static_cast<int>(first_face.size()) - 1; }
  /// On return x[point] is where the points are, the nodes being at X. False where one is nowhere,
  /// so that there is no sense in looking at the surface.
  bool place(std::span<const Vec<D>> X, std::vector<Vec<D>>& x) const;
};

}  // namespace washtub
