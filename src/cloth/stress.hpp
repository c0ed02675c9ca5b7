#pragma once
#include <array>
#include <span>

#include "cloth/strains.hpp"

namespace washtub {

/// Stress magnitudes at a node [Pa]: von Mises over the components in 3-D, the only component in
/// 2-D. `total` is that of the sums |membrane| + |bending| of each component, Eqs. (12) and (13).
struct NodeStress {
  double membrane = 0;
  double bending = 0;
  double total = 0;
  /// K_e/q times the mean of the strains of edges that are stretched, and of those that are
  /// compressed, both counted among all edges.
  double tension = 0, compression = 0;
  std::array<double, 3> component{};  ///< total of rr, ss, sr; in 2-D only ss
};

/// Stress at each node of a deformed sheet, with its membrane strains as they are now or in some
/// mean over time. Every component has its own stiffness over the
/// thickness q: K_e e/q and K_s e_sr/q in the mid-plane, 6 K_b kappa/q^2 and 6 K_t tau/q^2 at the
/// surface, with Poisson's cross terms between rr and ss, and the strains, curvatures and twist of
/// Eq. (12).
///
/// A strain belongs to an edge (shear and twist: to a quad); the node takes the mean of the
/// magnitudes of its two (four) neighbours, so that tension alternating from edge to edge counts in
/// full, neither cancelled nor doubled. A curvature belongs to a node; one on the border takes the
/// value of the node next to it. A closed direction has no border.
/// @throws InputError if the sheet's thickness is not given
void find_stress(const Sheet<3>& plate, std::span<const Vec<3>> X, const Strains& strains,
                 std::span<NodeStress> out);
void find_stress(const Sheet<2>& thread, std::span<const Vec<2>> X, const Strains& strains,
                 std::span<NodeStress> out);

}  // namespace washtub
