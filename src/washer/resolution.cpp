#include "washer/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/resolution.hpp"
#include "flow/grid_scale.hpp"
#include "solid/surface_speed.hpp"

namespace washtub {
namespace {

/// Of a cell, density speed h / viscosity, above which flows were not resolved in any reference
/// wash: 430 is in two dimensions, 870 is not in three.
constexpr double cell_reynolds_bound = 500;
constexpr double layer_bound = 0.2;  // thickness of layers along surfaces, in cells

/// What decides how fine a grid has to be.
struct Fineness {
  double cell = 0;      ///< longest edge [m]
  double speed = 0;     ///< omega_max r_o, or the fastest side or inflow [m/s]
  double reynolds = 0;  ///< of a cell
  double layer = 0;     ///< sqrt(nu / omega_max) [m]; 0 where nothing turns
};

Fineness fineness(const Case& whole) {
  Fineness f;
  for (int d = 0; d < whole.dimension; ++d)
    f.cell =
        std::max(f.cell, whole.domain.size[d] / whole.domain.cells[static_cast<std::size_t>(d)]);
  f.speed = whole.scale.speed * whole.scale.length;
  for (const auto& side : whole.domain.sides) f.speed = std::max(f.speed, side.velocity.norm());
  const double nu = whole.fluid.viscosity / whole.fluid.density;
  f.reynolds = f.speed * f.cell / nu;
  if (whole.scale.speed > 0) f.layer = std::sqrt(nu / whole.scale.speed);
  return f;
}

/// What helps: the viscosity that this grid resolves, and the cells that this viscosity wants.
std::string advice(const Case& whole) {
  const Fineness f = fineness(whole);
  const double finer = f.reynolds / cell_reynolds_bound;
  if (finer <= 1) return "try more domain.cells or a larger fluid.viscosity";
  return fmt::format(
      "try a fluid.viscosity of {:.2g} Pa s or more on this grid, or {:.2g} times as "
      "many domain.cells along every axis",
      whole.fluid.viscosity * finer, finer);
}

}  // namespace

void Resolution::take_worst(const Resolution& other) {
  grid_scale = std::max(grid_scale, other.grid_scale);
  speed = std::max(speed, other.speed);
  driving_speed = std::max(driving_speed, other.driving_speed);
}

template <int D>
double driving_speed(const Grid<D>& grid, const DomainMapping<D>& mapping,
                     const SidePairs<D>& sides, double start) {
  double fastest = fastest_surface(grid, mapping);
  for (const auto& pair : sides)
    for (const auto& side : pair) fastest = std::max(fastest, side.velocity.norm());
  return fastest > 0 ? fastest : start;
}

template <int D>
Resolution find_resolution(const Flow<D>& flow, double driving_speed, double speed) {
  const Vec<D> shares =
      grid_scale_energy<D>(flow.grid(), flow.velocity(), flow.openings().open, driving_speed);
  return {shares.maxCoeff(), speed, driving_speed};
}

std::optional<std::string> unresolved(const Resolution& worst, const Case& whole) {
  if (worst.resolved()) return {};
  std::string text = fmt::format(
      "The grid does not resolve this flow: up to {:.2g} % of the water's kinetic energy "
      "alternates "
      "from cell to cell (below {:.0f} % is good, white noise has 37.5 %)",
      100 * worst.grid_scale, 100 * Resolution::grid_scale_bound);
  if (worst.driving_speed > 0)
    text += fmt::format(
        ", and the water reaches {:.3g} m/s, {:.2g} times the {:.3g} m/s of what "
        "drives it",
        worst.speed, worst.speed_ratio(), worst.driving_speed);
  return text + ". Torque, stress and motion of such a run mean little; " + advice(whole) + ".";
}

std::optional<std::string> foresee_unresolved(const Case& whole) {
  const Fineness f = fineness(whole);
  if (f.reynolds <= cell_reynolds_bound || f.layer > layer_bound * f.cell) return {};
  std::string text = fmt::format(
      "the grid will hardly resolve this flow: at {:.3g} m/s the Reynolds number of a cell is "
      "{:.2g} (up to about {:.0f} is good)",
      f.speed, f.reynolds, cell_reynolds_bound);
  if (f.layer > 0)
    text += fmt::format(
        ", and layers along surfaces are about {:.2g} mm thick in cells of {:.3g} "
        "mm",
        1e3 * f.layer, 1e3 * f.cell);
  return text +
         ". Expect velocities that alternate from cell to cell, water several times faster "
         "than what drives it, and kinetic energy that grows from cycle to cycle; " +
         advice(whole);
}

std::vector<std::string> doubts(const Case& whole) {
  std::vector<std::string> found = unresolved(whole);
  if (auto text = foresee_unresolved(whole)) found.push_back(*std::move(text));
  return found;
}

template double driving_speed<2>(const Grid<2>&, const DomainMapping<2>&, const SidePairs<2>&,
                                 double);
template double driving_speed<3>(const Grid<3>&, const DomainMapping<3>&, const SidePairs<3>&,
                                 double);
template Resolution find_resolution<2>(const Flow<2>&, double, double);
template Resolution find_resolution<3>(const Flow<3>&, double, double);

}  // namespace washtub
