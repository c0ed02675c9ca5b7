#pragma once
#include <limits>

#include "support/water_box.hpp"

namespace washtub::testing {

/// A disc (solid 1) of some radius that turns inside a ring (solid 0) of radius 1, in a square box
/// of n x n cells.
inline WaterSetup<2> annulus(double width, int n, double radius, const Drive& disc,
                             const Drive& ring, double viscosity, const Heaviside& heaviside = {}) {
  const double inf = std::numeric_limits<double>::infinity();
  return {.mesh = cubic_mesh<2>(Vec<2>::Constant(-width / 2), width, n),
          .solids = {{"ring", complement(cylinder(1, -inf, inf)), Vec<3>::Zero(), ring},
                     {"disc", cylinder(radius, -inf, inf), Vec<3>::Zero(), disc}},
          .density = 1,
          .viscosity = viscosity,
          .heaviside = heaviside};
}

}  // namespace washtub::testing
