#pragma once
#include <vector>

#include "case/case.hpp"
#include "washer/rectangle.hpp"

namespace washtub {

/// A piece of cloth as it starts: flat, bent to an arc along r, or rippled. In 2-D, a curve.
struct Patch {
  Vec<3> origin = Vec<3>::Zero();  ///< where r = s = 0 [m]
  std::array<Vec<3>, 2> along{};   ///< unit vectors of r and s there; in 2-D the second one is zero
  Vec<3> normal = Vec<3>::Zero();  ///< unit vector there
  std::array<double, 2> size{};    ///< arc lengths [m]; in 2-D the second one is 0
  double curvature = 0;            ///< along r, towards the normal [1/m]
  double ripple = 0;               ///< normal displacement ripple sin(2 pi ripples r/size + phase)
  double ripples = 0, phase = 0;
  /// Folded or crumpled: places of the nodes from the centre, along r, s and the normal [m]; they
  /// lie within half of `thickness` from the flat patch.
  std::vector<Vec<3>> packed{};
  double thickness = 0;  ///< [m]

  /// The point at arc length r along the unrippled curve, and s [m].
  Vec<3> at(double r, double s) const;
  /// The unit vector normal to the unrippled curve there.
  Vec<3> normal_at(double r) const;
};

/// Flat pieces that stand for a patch from r = from to r = to [m] and along all of s: none of its
/// points is further than `slack` from them.
struct Facets {
  std::vector<Rectangle> flat;
  double slack = 0;  ///< [m]
  Vec<3> centre;     ///< no point of them is further from it than
  double reach = 0;  ///< this [m]
};
Facets facets(const Patch& patch, std::array<double, 2> r, std::array<double, 2> s);
Facets facets(const Patch& patch);

/// Whether two patches are nearer than `clearance` [m], or cross.
bool near(const Facets& a, const Facets& b, double clearance);

/// A patch about `centre`: where its middle is, and how its directions point there.
Patch centred_patch(const Vec<3>& centre, const Vec<3>& along_r, const Vec<3>& along_s,
                    std::array<double, 2> size, double curvature);
/// The patch of a single sheet or ring.
Patch sheet_patch(const ClothCase& cloth, const Case& whole);
Patch ring_patch(const ClothCase& cloth);

/// r (0) or s (1) of the nodes in turn [m], so that cloth bent to an arc is unstretched along r.
std::vector<double> node_lines(const Patch& patch, const ClothCase& cloth, const Case& whole,
                               int direction);

}  // namespace washtub
