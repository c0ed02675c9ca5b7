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
/// A component of a field is met at `kernel_points` neighbouring values of some rows along x: the
/// product of a vector along x with one weight for each other axis.
template <int D>
class Stencils {
 public:
  using Weights = std::array<double, kernel_points>;
  /// Where each axis is met: [0] on cell centres, [1] on faces normal to it.
  template <class T>
  using Staggered = std::array<T, 2>;
  /// Where a delta function stands in this rank's block: the places in memory that it meets are
  /// sums of a start along x, with the points that follow, and of one offset for each other axis.
  struct Place {
    Staggered<long> start;  ///< on a periodic axis a row may go on at its own beginning
    /// Lines of another rank, of weight 0, are moved into the block.
    std::array<Staggered<std::array<long, kernel_points>>, D - 1> offset;
  };
  using WeightsOfAxes = std::array<Staggered<Weights>, D>;

  /// @param sides    those of the flow; how they reflect and how they move follows from it
  /// @param spacing  largest distance between markers, in shortest cell edges
  Stencils(const Grid<D>& grid, const Cloth<D>& cloth, Kernel kernel, const SidePairs<D>& sides,
           double spacing);

  /// Puts the delta functions at the given node positions [m].
  /// @throws RunError naming the piece, if one reaches beyond an open side
  void place(const std::vector<Vec<D>>& X);

  const Markers<D>& markers() const { return markers_; }
  /// Lines along each axis but x that the kernel reaches: the first of `kernel_points`.
  int points() const { return points_; }
  /// Markers whose delta function touches this rank's block; only these have a place and weights.
  const std::vector<int>& local() const { return local_; }
  /// Places and weights of the local markers, in their order.
  const std::vector<Place>& places() const { return places_; }
  const std::vector<WeightsOfAxes>& weights() const { return weights_; }
  /// Markers that moving sides drag along [m/s].
  const std::vector<std::pair<int, Vec<D>>>& given() const { return given_; }

 private:
  /// Neighbouring grid lines along one axis; on a periodic one the last of them may be the first of
  /// the box again.
  struct Line {
    KernelLine kernel;  ///< start: from 0 to below the number of cells
    double given = 0;   ///< weight of the velocity of the side that the delta function reaches
    int side = 0;       ///< which that is
  };
  using Lines = std::array<Staggered<Line>, D>;

  bool find_lines(const Vec<D>& x, Lines& lines) const;
  Line fold(const KernelLine& l, int axis, bool on_faces) const;
  bool reaches_block(const Line& l, int axis) const;
  void keep(int marker, const Lines& lines);
  void keep_off_open_sides(const Vec<D>& x, int marker) const;
  Vec<D> drag(const Lines& lines) const;

  const Grid<D>& grid_;
  const Cloth<D>& cloth_;
  Kernel kernel_;
  int points_;
  std::array<std::array<Reflection, 2>, D> sides_{};
  std::array<std::array<Vec<D>, 2>, D> side_velocity_;  ///< [m/s], of odd sides
  bool moving_sides_ = false;
  Markers<D> markers_;
  std::vector<int> local_;
  std::vector<Place> places_;
  std::vector<WeightsOfAxes> weights_;
  std::vector<std::pair<int, Vec<D>>> given_;
};

}  // namespace washtub
