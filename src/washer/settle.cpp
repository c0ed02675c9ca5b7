#include "washer/settle.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr double at_rest_below = 0.02;  // of the largest speed that the cloth has had

template <int D>
double rms_speed(const Cloth<D>& cloth) {
  double squares = 0;
  for (const Vec<D>& v : cloth.velocity) squares += v.squaredNorm();
  return std::sqrt(squares / std::max(cloth.nodes(), 1));
}

}  // namespace

Case settling_case(const Case& whole) {
  Case still = whole;
  for (SolidCase& solid : still.solids) solid.drive = at_rest();
  for (SideCase& side : still.domain.sides) side.velocity.setZero();
  for (ClothCase& cloth : still.cloth) cloth.load = ClothCase().load;
  still.fluid.velocity = FluidCase().velocity;
  still.fluid.gravity = whole.settle.gravity;
  still.time.end = whole.settle.time;
  still.settle.time = 0;
  return still;
}

template <int D>
Settled<D> settle(const Case& whole, const Parallel& parallel,
                  const std::function<bool(const Simulation<D>&)>& watch) try {
  const Case still = settling_case(whole);
  Simulation<D> simulation(still, parallel);
  Settled<D> settled;
  double fastest = 0;
  do {
    simulation.step(still.time.end);
    settled.speed = rms_speed(simulation.cloth());
    fastest = std::max(fastest, settled.speed);
    settled.at_rest = settled.speed <= at_rest_below * fastest;
    settled.stopped = !watch(simulation);
  } while (!settled.stopped && !settled.at_rest && simulation.time() < (1 - 1e-9) * still.time.end);
  settled.time = simulation.time();
  settled.places = simulation.cloth().position;
  return settled;
} catch (const RunError& error) {
  throw RunError(std::string("while the cloth settled: ") + error.what());
}

template Settled<2> settle(const Case&, const Parallel&,
                           const std::function<bool(const Simulation<2>&)>&);
template Settled<3> settle(const Case&, const Parallel&,
                           const std::function<bool(const Simulation<3>&)>&);

}  // namespace washtub
