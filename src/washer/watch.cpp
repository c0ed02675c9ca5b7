#include "washer/watch.hpp"

#include <fmt/format.h>

#include <cmath>

#include "washer/overstrained.hpp"
#include "washer/places.hpp"

namespace washtub {
namespace {

std::string pressure_text(const StepHealth& step) {
  return fmt::format(
      "the pressure solve left |div u| h/U = {:.2g} after {} cycles; try a larger "
      "solver.max_cycles",
      step.divergence, step.cycles);
}

std::string courant_text(const StepHealth& step, const WatchLimits& limits) {
  return fmt::format(
      "the water goes {:.2g} cells in a step of {:.3g} s, limit {:.2g}; try a "
      "time.step of {:.1g} s, or time.fixed = false",
      step.courant, step.dt, limits.courant, 0.3 * step.dt / step.courant);
}

std::string slip_text(const StepHealth& step, const WatchLimits& limits) {
  return fmt::format(
      "the cloth slips through the water at {:.2g} m/s (rms over its nodes), {:.0f} "
      "% of the {:.2g} m/s of what drives it, limit {:.0f} %; try a smaller "
      "time.step or time.cfl",
      step.slip, 100 * step.slip / step.driving_speed, step.driving_speed, 100 * limits.slip);
}

std::string speed_text(const StepHealth& step, const WatchLimits& limits,
                       const std::string& place) {
  return fmt::format(
      "the water reaches {:.3g} m/s {}, {:.0f} times the {:.2g} m/s of what drives "
      "it, limit {:.0f}: the grid does not resolve this flow; try more domain.cells "
      "or a larger fluid.viscosity",
      step.speed, place, step.speed / step.driving_speed, step.driving_speed, limits.speed);
}

bool is_finite(const StepHealth& step) {
  return std::isfinite(step.kinetic) && std::isfinite(step.divergence) &&
         std::isfinite(step.strain) && std::isfinite(step.slip);
}

}  // namespace

template <int D>
std::optional<Trouble> find_trouble(const StepHealth& step, const Flow<D>& flow,
                                    const Cloth<D>& cloth, const Case& whole,
                                    const WatchLimits& limits) {
  const auto trouble = [&](TroubleKind kind, const std::string& what) {
    return Trouble{kind, fmt::format("step {}, t = {:.6g} s: {}", step.number, step.time, what)};
  };
  if (!is_finite(step)) {
    const std::string place = not_finite(flow, cloth);
    return trouble(TroubleKind::not_finite,
                   fmt::format("{} is no longer a finite number; try a smaller time.step or "
                               "time.cfl",
                               place.empty() ? "the state" : place));
  }
  if (!step.converged && step.divergence > limits.divergence)
    return trouble(TroubleKind::pressure, pressure_text(step));
  if (whole.time.fixed && step.courant > limits.courant)
    return trouble(TroubleKind::courant, courant_text(step, limits));
  const double strain_limit = whole.coupling.strain_limit;
  if (step.strain > strain_limit) {
    const WorstEdge edge = worst_edge(cloth);
    if (std::abs(edge.strain) > strain_limit)
      return trouble(TroubleKind::strain, overstrained(edge, whole));
  }
  const double drive = step.driving_speed;
  if (drive > 0 && step.slip > limits.slip * drive)
    return trouble(TroubleKind::slip, slip_text(step, limits));
  if (drive > 0 && step.speed > limits.speed * drive)
    return trouble(TroubleKind::speed, speed_text(step, limits, place_of_largest_speed(flow)));
  return {};
}

template std::optional<Trouble> find_trouble<2>(const StepHealth&, const Flow<2>&, const Cloth<2>&,
                                                const Case&, const WatchLimits&);
template std::optional<Trouble> find_trouble<3>(const StepHealth&, const Flow<3>&, const Cloth<3>&,
                                                const Case&, const WatchLimits&);

}  // namespace washtub
