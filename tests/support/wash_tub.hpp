#pragma once
#include <limits>
#include <numbers>

#include "solid/agitator.hpp"
#include "support/water_box.hpp"

namespace washtub::testing {

inline constexpr double tub_radius = 0.31, tub_depth = 0.2376, tub_width = 0.7128;
inline constexpr double peak_speed = 4 * std::numbers::pi;

/// The box of the reference wash (reference.md, section 3) with n cells along each axis.
inline Mesh<3> wash_mesh(int n) {
  Mesh<3> m;
  m.lower = {-tub_width / 2, -tub_width / 2, 0};
  m.h = Vec<3>(tub_width, tub_width, tub_depth) / n;
  m.cells = {n, n, n};
  return m;
}

inline std::vector<Solid> wash_solids(bool agitator) {
  const double inf = std::numeric_limits<double>::infinity();
  std::vector<Solid> s{
      {"tub", complement(cylinder(tub_radius, -inf, inf)), Vec<3>::Zero(), at_rest()}};
  if (agitator)
    s.push_back({"agitator", shape(reference_agitator_3d(tub_radius, tub_depth)), Vec<3>::Zero(),
                 sinusoid(peak_speed, 2 / std::numbers::pi)});
  return s;
}

/// Floor and lateral sides at rest, perfect slip on top.
inline SidePairs<3> wash_sides() {
  SidePairs<3> sides;
  sides[2][1].kind = Side<3>::Kind::slip;
  return sides;
}

/// Water alone in the reference tub.
struct WashTub : WaterBox<3> {
  WashTub(int n, double viscosity, bool agitator = true, const Parallel& parallel = Parallel())
      : WaterBox<3>({.mesh = wash_mesh(n),
                     .solids = wash_solids(agitator),
                     .density = 1000,
                     .viscosity = viscosity,
                     .sides = wash_sides()},
                    parallel) {}
};

}  // namespace washtub::testing
