#pragma once
#include <array>

#include "base/vec.hpp"
#include "solid/solid.hpp"

namespace washtub {

/// A flat piece of cloth in space: corner + r edge[0] + s edge[1] for r, s in [0, 1]. The edges are
/// at right angles; in 2-D the second one is zero.
struct Rectangle {
  Vec<3> corner;
  std::array<Vec<3>, 2> edge;

  Vec<3> at(double r, double s) const { return corner + r * edge[0] + s * edge[1]; }
  Vec<3> centre() const { return at(0.5, 0.5); }
  /// Half the diagonal: no point is further from the centre [m].
  double reach() const { return 0.5 * (edge[0] + edge[1]).norm(); }
  /// Corners in the order in which the border meets them.
  std::array<Vec<3>, 4> corners() const { return {at(0, 0), at(1, 0), at(1, 1), at(0, 1)}; }
};

using Segment = std::array<Vec<3>, 2>;  ///< its ends

/// Smallest distance between two segments [m]; either may be a point.
double distance(const Segment& a, const Segment& b);

/// Smallest distance between two rectangles [m]; 0 where they cross.
double distance(const Rectangle& a, const Rectangle& b);

/// Whether psi <= -clearance on the whole rectangle, to `resolution` [m]. Relies on psi being
/// Lipschitz with constant 1.
bool is_clear_of(const SolidPose& solid, const Rectangle& piece, double clearance,
                 double resolution);

}  // namespace washtub
