#pragma once
#include <array>
#include <utility>
#include <vector>

#include "coupling/kernel.hpp"
#include "coupling/markers.hpp"
#include "flow/sides.hpp"

namespace washtub {

/// What a side of the box does to a delta function that reaches beyond it.
enum class Reflection {
  none,  ///< periodic: it goes on at the opposite side, after any number of periods
  odd,  ///< wall or inflow: what falls beyond counts as twice the side's velocity less the mirrored
        ///< value, so that cloth on the side moves with it
  even,  ///< slip: what falls beyond is mirrored
  open,  ///< outflow or far field: nothing is known there, cloth must not come that near
};

/// Where the delta functions of the markers stand in the grid, and what their weights are there.
template <int D>
class Stencils {
 public:
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

  /// @param sides    those of the flow; how they reflect and how they move follows from it
  /// @param spacing  largest distance between markers, in shortest cell edges
  Stencils(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel, const SidePairs<D>& sides,
           double spacing);

  /// Puts the delta functions at the given node positions [m].
  /// @throws RunError naming the piece, if one reaches beyond an open side
  void place(const std::vector<Vec<D>>& X);

  const Markers<D>& markers() const { return markers_; }
  const Stencil& operator[](int marker) const { return stencils_[marker]; }
  /// Markers whose delta function touches this rank's block.
  const std::vector<int>& local() const { return local_; }
  /// Markers that moving sides drag along [m/s].
  const std::vector<std::pair<int, Vec<D>>>& given() const { return given_; }

 private:
  Line line(double x, int axis, bool on_faces) const;
  void keep_off_open_sides(const Vec<D>& x, int marker) const;
  Vec<D> drag(const Stencil& s) const;
  bool reaches_block(const Stencil& s) const;

  const Grid<D>& grid_;
  const Cloth<D>& cloth_;
  Kernel kernel_;
  std::array<std::array<Reflection, 2>, D> sides_{};
  std::array<std::array<Vec<D>, 2>, D> side_velocity_;  ///< [m/s], of odd sides
  bool moving_sides_ = false;
  Markers<D> markers_;
  std::vector<Stencil> stencils_;
  std::vector<int> local_;
  std::vector<std::pair<int, Vec<D>>> given_;
};

}  // namespace washtub
