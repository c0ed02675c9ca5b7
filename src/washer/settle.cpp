#include "washer/settle.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr int looks = 50;               // at whether the cloth rests
constexpr double at_rest_below = 0.05;  // of the speed at which it would sink

double sinking_speed(const Case& whole) {
  double heaviest = 0;
  for (const ClothCase& cloth : whole.cloth)
    heaviest = std::max(heaviest, cloth.material.excess_mass);
  return std::sqrt(whole.settle.gravity.norm() * heaviest / whole.fluid.density);
}

/// Of the ways from x to y.
template <int D>
double rms_way(const std::vector<Vec<D>>& x, const std::vector<Vec<D>>& y) {
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += (y[i] - x[i]).squaredNorm();
  return std::sqrt(squares / std::max(static_cast<double>(x.size()), 1.0));
}

}  // namespace

Case settling_case(const Case& whole, double share) {
  Case still = whole;
  for (SolidCase& solid : still.solids) solid.drive = at_rest();
  for (SideCase& side : still.domain.sides) side.velocity.setZero();
  for (ClothCase& cloth : still.cloth) cloth.load = ClothCase().load;
  still.fluid.velocity = FluidCase().velocity;
  still.fluid.gravity = whole.settle.gravity;
  still.time.end = whole.settle.time;
  still.time.step *= share;
  still.time.cfl *= share;
  still.settle.time = 0;
  return still;
}

template <int D>
Settled<D> settle(const Case& whole, const Parallel& parallel,
                  const std::function<bool(const Simulation<D>&)>& watch, double share) try {
  Simulation<D> simulation(settling_case(whole, share), parallel);
  const double span = whole.settle.time / looks, slow = at_rest_below * sinking_speed(whole);
  Settled<D> settled;
  for (int look = 1; look <= looks && !settled.at_rest && !settled.stopped; ++look) {
    const std::vector<Vec<D>> before = simulation.cloth().position;
    while (!settled.stopped && simulation.time() < (look - 1e-6) * span) {
      simulation.step(look * span);
      settled.stopped = !watch(simulation);
    }
    const double speed = rms_way(before, simulation.cloth().position) / span;
    settled.at_rest = speed <= std::min(slow, settled.speed);
    settled.speed = speed;
  }
  settled.time = simulation.time();
  settled.places = simulation.cloth().position;
  return settled;
} catch (const RunError& error) {
  throw RunError(std::string("while the cloth settled: ") + error.what() +
                 "; here a smaller settle.gravity may help too");
}

template Settled<2> settle(const Case&, const Parallel&,
                           const std::function<bool(const Simulation<2>&)>&, double);
template Settled<3> settle(const Case&, const Parallel&,
                           const std::function<bool(const Simulation<3>&)>&, double);

}  // namespace washtub
