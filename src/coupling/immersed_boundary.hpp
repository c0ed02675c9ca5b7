#pragma once
#include <vector>

#include "coupling/stencils.hpp"
#include "flow/provisional.hpp"

namespace washtub {

/// Carries nodal forces to the grid, Eq. (3), and grid velocities to the nodes, Eq. (5), through
/// the markers and the regularised delta function of Eq. (7). Both use the same weights: they are
/// adjoint. Each rank works on the faces of its own block; nodal results are summed over the ranks.
template <int D>
class ImmersedBoundary {
 public:
  /// @param sides           those of the flow; how they reflect and how they move follows from it
  /// @param marker_spacing  largest distance between markers, in shortest cell edges
  ImmersedBoundary(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel,
                   const SidePairs<D>& sides, double marker_spacing = 2);

  /// Puts the delta functions at the given node positions [m].
  /// @throws RunError naming the piece, if one reaches beyond an open side
  void place(const std::vector<Vec<D>>& X) { stencils_.place(X); }

  /// Adds the force density of nodal forces G [N] to f [N/m^3] on this rank's faces.
  void spread(const std::vector<Vec<D>>& G, Components<D>& f) const;
  /// On return U holds the velocity [m/s] at every node, on all ranks.
  void interpolate(const Components<D>& u, std::vector<Vec<D>>& U) const;
  void interpolate(const ProvisionalVelocity<D>& u, std::vector<Vec<D>>& U) const;
  /// Lumped mobility D_i [1/kg]: the velocity per impulse of node i when all nodes are pushed alike
  /// and closed faces do not give way.
  void mobility(const Openings<D>& openings, double density, std::vector<Vec<D>>& mobility);

 private:
  template <class Component>
  void gather(Component&& component, std::vector<Vec<D>>& U) const;
  void add_given(std::vector<Vec<D>>& U) const;

  const Grid<D>& grid_;
  Stencils<D> stencils_;
  Components<D> ones_;
  std::vector<Vec<D>> unit_;
};

}  // namespace washtub
