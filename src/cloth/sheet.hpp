#pragma once
#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "cloth/element.hpp"
#include "cloth/material.hpp"

namespace washtub {

/// An elastic sheet at rest: a regular grid over arc length (r, s), the elements of its discrete
/// energy W, and nothing that changes while it moves. Node (i, j) at r = i ds_r, s = j ds_s has
/// number i + extent[0] j. Built by `make_plate` (3-D) and `make_thread` (2-D, extent {1, n}).
/// States are given as one position per node; energies, forces and masses of a thread are per unit
/// depth.
template <int D>
struct Sheet {
  std::array<int, 2> extent{};      ///< nodes along r and s
  std::array<double, 2> spacing{};  ///< ds_r, ds_s [m]; ds_r unused in 2-D
  Material material;
  /// Along r and s: beyond the last node comes the first one again, moved by `period` [m] (0 in a
  /// ring or tube).
  std::array<bool, 2> closed{};
  std::array<Vec<D>, 2> period{Vec<D>::Zero(), Vec<D>::Zero()};
  std::vector<double> area;  ///< per node [m^2], in 2-D length [m]; halved on a border
  Elements<D, false> inner;  ///< all but those across a seam with a period
  Elements<D, true> seam;

  int nodes() const { return extent[0] * extent[1]; }
  int node(int i, int j) const { return i + extent[0] * j; }
  /// Node (i, j), where i and j may lie up to a whole turn beyond the seam of a closed direction.
  Image<D> image(int i, int j) const;
  /// Where that is, the nodes being at X [m].
  Vec<D> place(std::span<const Vec<D>> X, int i, int j) const {
    const Image<D> at = image(i, j);
    return X[static_cast<std::size_t>(at.node)] + at.shift;
  }
  /// Intervals between nodes along an axis, that of the seam included.
  int intervals(int axis) const { return closed[axis] ? extent[axis] : extent[axis] - 1; }
  /// Whether the i-th node along an axis has a neighbour on either side.
  bool inside(int axis, int i) const { return closed[axis] || (i > 0 && i < extent[axis] - 1); }
  double smallest_spacing() const;

  /// Elastic energy W [J].
  double energy(std::span<const Vec<D>> X) const;
  /// On return F = -dW/dX [N], exactly, so that its sum and its moment vanish.
  void force(std::span<const Vec<D>> X, std::span<Vec<D>> F) const;
  /// Largest |E| over the edges.
  double largest_strain(std::span<const Vec<D>> X) const;
  /// d2W/dX2 [N/m], of size D nodes, node by node, except that springs of the geometric part under
  /// compression are cut at `floor` <= 0 [N/m]; with floor = 0 it is positive semi-definite.
  Eigen::SparseMatrix<double> hessian(std::span<const Vec<D>> X, double floor) const;
};

template <int D>
Image<D> Sheet<D>::image(int i, int j) const {
  std::array<int, 2> at{i, j};
  Vec<D> shift = Vec<D>::Zero();
  for (int d = 0; d < 2; ++d) {
    if (!closed[d]) continue;
    const int turns = at[d] < 0 ? -1 : at[d] >= extent[d];
    at[d] -= turns * extent[d];
    shift += turns * period[d];
  }
  return {node(at[0], at[1]), shift};
}

}  // namespace washtub
