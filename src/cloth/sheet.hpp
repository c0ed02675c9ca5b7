#pragma once
#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "cloth/material.hpp"

namespace washtub {

/// Energy of one membrane strain, E = offset + sum_k weight_k |X_{b_k} - X_{a_k}|^2 over N legs
/// (a_k, b_k): W = stiffness E^2 / 2. In that form the geometric part of the Hessian is a spring of
/// stiffness 2 weight_k dW/dE along each leg.
template <int N>
struct Strain {
  std::array<std::array<int, 2>, N> leg;
  std::array<double, N> weight;  ///< [1/m^2]
  double offset = 0;
  double stiffness = 0;  ///< [J]; per unit depth in 2-D
};

/// Energy of one second difference v = sum_k weight_k X_{node_k} over `count` nodes:
/// W = stiffness |v|^2 / 2, so that its Hessian is constant.
struct Bend {
  int count = 0;
  std::array<int, 5> node{};
  std::array<double, 5> weight{};  ///< [1/m^2]
  double stiffness = 0;            ///< [J m^2]; per unit depth in 2-D
};

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
  std::vector<double> area;          ///< per node [m^2], in 2-D length [m]; borders halved
  std::vector<Strain<1>> edges;      ///< E_ss and E_rr of single edges
  std::vector<Strain<2>> shears;     ///< E_sr of quads, by their diagonals
  std::vector<Strain<4>> dilations;  ///< E_ss + E_rr of quads, if nu is not 0
  std::vector<Bend> bends;           ///< curvatures and twist

  int nodes() const { return extent[0] * extent[1]; }
  int node(int i, int j) const { return i + extent[0] * j; }
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

}  // namespace washtub
