#pragma once
#include <cmath>
#include <span>

#include "base/vec.hpp"
#include "measure/statistics.hpp"

namespace washtub {

/// Area-weighted mean of a piece's nodes [m]; `area` per node as the sheet gives it (borders
/// halved), which makes it the centre of mass of a uniform piece.
template <int D>
Vec<D> centre_of_mass(std::span<const Vec<D>> points, std::span<const double> area) {
  Vec<D> sum = Vec<D>::Zero();
  double total = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    sum += area[i] * points[i];
    total += area[i];
  }
  return sum / total;
}

/// (r, z) of a point: distance from the tub's vertical axis through (x, y) = `axis`, and height,
/// as in the paper's Figs. 8-10 [m]. In 2-D z = 0.
template <int D>
Vec<2> radius_height(const Vec<D>& x, const Vec<2>& axis) {
  const double r = std::hypot(x[0] - axis[0], x[1] - axis[1]);
  if constexpr (D == 3)
    return {r, x[2]};
  else
    return {r, 0.0};
}

/// Time-averaged position of a track, trapezoidal in time [m].
Vec<2> mean_position(std::span<const double> times, std::span<const Vec<2>> track);

/// How a track (r, z)(t) goes round. Counter-clockwise with r to the right and z up is positive:
/// out along the bottom, up the wall, in under the surface, down the axis, as the paper finds at
/// Re >= 1200.
struct Loop {
  Vec<2> centre;     ///< time-averaged position [m]
  double area = 0;   ///< swept about the centre, 1/2 integral of (x - c) x dx [m^2]
  double turns = 0;  ///< winding about the centre, in whole turns
};

Loop loop(std::span<const double> times, std::span<const Vec<2>> track);

/// Coarse map of the mean velocity in (r, z), where the loop of the wash shows: each step between
/// two samples of a track counts with its duration at its midpoint.
class VelocityMap {
 public:
  /// Water of depth H in a tub of radius r_o [m].
  VelocityMap(double tub_radius, double depth) : radius_(tub_radius), depth_(depth) {}

  void add(std::span<const double> times, std::span<const Vec<2>> track);

  const Statistics& wall_rise() const { return wall_; }        ///< dz/dt at r > 0.7 r_o [m/s]
  const Statistics& axis_rise() const { return axis_; }        ///< dz/dt at r < 0.5 r_o [m/s]
  const Statistics& top_outward() const { return top_; }       ///< dr/dt at z > 2/3 H [m/s]
  const Statistics& bottom_outward() const { return floor_; }  ///< dr/dt at z < 1/3 H [m/s]
  /// Signs that agree with the loop of the wash (wall up, top inward, axis down, bottom outward),
  /// 0 to 4; a region that was never visited does not agree.
  int agreeing() const;

 private:
  double radius_, depth_;
  Statistics wall_, axis_, top_, floor_;
};

}  // namespace washtub
