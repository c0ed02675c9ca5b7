#pragma once
#include <limits>
#include <numbers>

#include "flow/flow.hpp"
#include "solid/agitator.hpp"
#include "solid/mapping.hpp"

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
inline std::array<std::array<Side<3>, 2>, 3> wash_sides() {
  std::array<std::array<Side<3>, 2>, 3> sides;
  sides[2][1].kind = Side<3>::Kind::slip;
  return sides;
}

template <int D>
Openings<D> openings(const DomainMapping<D>& mapping) {
  return {mapping.open(), mapping.smooth()};
}

/// Water alone in the reference tub.
struct WashTub {
  Grid<3> grid;
  DomainMapping<3> mapping;
  Flow<3> flow;
  double t = 0;

  WashTub(int n, double viscosity, bool agitator = true)
      : grid(wash_mesh(n), Parallel(), granularity(wash_mesh(n))),
        mapping(grid, wash_solids(agitator), 0),
        flow(grid, 1000, viscosity, wash_sides(), openings(mapping)) {}

  Flow<3>::Report step(double dt, double tolerance = 1e-4) {
    t += dt;
    const auto change = mapping.update(t);
    const auto [k0, k1] = mapping.moving_planes();
    if (change.any) flow.openings_changed(k0, k1, change.flipped);
    mapping.impose(flow.velocity());
    flow.predict(dt);
    return flow.project(dt, tolerance, 60);
  }
};

}  // namespace washtub::testing
