#pragma once
#include <array>
#include <span>
#include <vector>

#include "coupling/kernel.hpp"
#include "coupling/markers.hpp"
#include "flow/flow.hpp"

namespace washtub {

/// What a side of the box does to a delta function that reaches beyond it.
enum class Reflection {
  none,  ///< periodic: it goes on at the opposite side, after any number of periods
  odd,  ///< wall or inflow: what falls beyond counts as twice the side's velocity less the mirrored
        ///< value, so that cloth on the side moves with it
  even,  ///< slip: what falls beyond is mirrored
  open,  ///< outflow or far field: nothing is known there, cloth must not come that near
};

/// Carries nodal forces to the grid, Eq. (3), and grid velocities to the nodes, Eq. (5), through
/// the markers and the regularised delta function of Eq. (7). Both use the same weights: they are
/// adjoint. Each rank works on the faces of its own block; nodal results are summed over the ranks.
template <int D>
class ImmersedBoundary {
 public:
  /// @param sides           those of the flow; how they reflect and how they move follows from it
  /// @param marker_spacing  largest distance between markers, in shortest cell edges
  ImmersedBoundary(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel,
                   const std::array<std::array<Side<D>, 2>, D>& sides, double marker_spacing = 2);

  /// Puts the delta functions at the given node positions [m].
  /// @throws RunError naming the piece, if one reaches beyond an open side
  void place(const std::vector<Vec<D>>& X);

  /// Adds the force density of nodal forces G [N] to f [N/m^3] on this rank's faces.
  void spread(const std::vector<Vec<D>>& G, Components<D>& f) const;
  /// On return U holds the velocity [m/s] at every node, on all ranks.
  void interpolate(const Components<D>& u, std::vector<Vec<D>>& U) const;
  /// Lumped mobility D_i [1/kg]: the velocity per impulse of node i when all nodes are pushed alike
  /// and closed faces do not give way.
  void mobility(const Openings<D>& openings, double density, std::vector<Vec<D>>& mobility);

 private:
  using Weights = std::array<double, kernel_points>;
  /// Neighbouring grid lines along one axis; on a periodic one the last of them may be the first of
  /// the box again.
  struct Line {
    int start;  ///< from 0 to below the number of cells
    Weights weight;
    double given = 0;  ///< weight of the velocity of the side that the delta function reaches
    int side = 0;      ///< which that is
  };
  struct Stencil {
    std::array<Line, D> face, centre;  ///< along an axis: on faces normal to it, on cell centres
    const Line& along(int axis, int component) const {
      return axis == component ? face[axis] : centre[axis];
    }
  };
  struct OwnLines {
    int count = 0;
    std::array<long, kernel_points> offset;  ///< in memory, from the first row of the block
    Weights weight;
  };
  Line line(double x, int axis, bool on_faces) const;
  void keep_off_open_sides(const Vec<D>& x, int marker) const;
  Vec<D> given(const Stencil& s) const;
  OwnLines own(const Line& l, int axis) const;
  bool reaches_block(const Stencil& s) const;
  template <class Visit>
  void for_rows(const Stencil& s, int component, Visit&& visit) const;
  template <class Value>
  void gather(Value&& value, std::vector<Vec<D>>& U) const;

  const Grid<D>& grid_;
  const Cloth<D>& cloth_;
  Kernel kernel_;
  std::array<std::array<Reflection, 2>, D> sides_{};
  std::array<std::array<Vec<D>, 2>, D> side_velocity_;  ///< [m/s], of odd sides
  bool moving_sides_ = false;
  double spacing_;
  Markers<D> markers_;
  std::vector<Stencil> stencils_;
  std::vector<int> local_;  ///< markers whose delta function touches this rank's block
  std::vector<std::pair<int, Vec<D>>> given_;  ///< markers that moving sides drag along [m/s]
  Components<D> ones_;
  std::vector<Vec<D>> unit_;
};

}  // namespace washtub
