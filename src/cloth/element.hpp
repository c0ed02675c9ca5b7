#pragma once
#include <array>
#include <limits>
#include <type_traits>
#include <vector>

#include "base/vec.hpp"

namespace washtub {

/// A node as met on the way across the seams of a closed sheet: it stands moved by `shift` [m].
template <int D>
struct Image {
  int node;
  Vec<D> shift;
};

/// What an element across a seam has beside the others, which need neither memory nor time for it.
struct NoShift {};
template <bool seam, class Shift>
using IfSeam = std::conditional_t<seam, Shift, NoShift>;

/// How much stiffer an edge is beyond a strain: W gains stiffness (E - knee)^2 / 2 there.
struct Stiffening {
  double knee = std::numeric_limits<double>::infinity();
  double stiffness = 0;  ///< [J]; per unit depth in 2-D
};

/// What only single edges have.
struct Linear {};
template <int N, class Law>
using IfEdge = std::conditional_t<N == 1, Law, Linear>;

/// Energy of one membrane strain, E = offset + sum_k weight_k |X_{b_k} + shift_k - X_{a_k}|^2 over
/// N legs (a_k, b_k): W = stiffness E^2 / 2, more in stiffened edges. In that form the geometric
/// part of the Hessian is a spring of stiffness 2 weight_k dW/dE along each leg.
template <int D, int N, bool seam>
struct Strain {
  using Shift = std::array<std::array<double, D>, N>;

  std::array<std::array<int, 2>, N> leg;
  std::array<double, N> weight;  ///< [1/m^2]
  double offset = 0;
  double stiffness = 0;  ///< [J]; per unit depth in 2-D
  [[no_unique_address]] IfEdge<N, Stiffening> beyond{};
  [[no_unique_address]] IfSeam<seam, Shift> shift{};  ///< [m]
};

/// Energy of one second difference v = shift + sum_k weight_k X_{node_k} over `count` nodes:
/// W = stiffness |v|^2 / 2, so that its Hessian is constant.
template <int D, bool seam>
struct Bend {
  using Shift = std::array<double, D>;

  int count = 0;
  std::array<int, 5> node{};
  std::array<double, 5> weight{};                     ///< [1/m^2]
  double stiffness = 0;                               ///< [J m^2]; per unit depth in 2-D
  [[no_unique_address]] IfSeam<seam, Shift> shift{};  ///< [1/m]
};

/// The elements of a sheet's energy, those across its seams or the others.
template <int D, bool seam>
struct Elements {
  std::vector<Strain<D, 1, seam>> edges;      ///< E_ss and E_rr of single edges
  std::vector<Strain<D, 2, seam>> shears;     ///< E_sr of quads, by their diagonals
  std::vector<Strain<D, 4, seam>> dilations;  ///< E_ss + E_rr of quads, if nu is not 0
  std::vector<Bend<D, seam>> bends;           ///< curvatures and twist
};

}  // namespace washtub
