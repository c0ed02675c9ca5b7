#include "measure/energy_balance.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {

double EnergyBalance::share() const {
  const double scale = std::max(std::abs(work), heat);
  return scale > 0 ? rest() / scale : 0;
}

void EnergyBalance::add(const EnergyState& before, const EnergyState& now) {
  const double dt = now.time - before.time;
  time += dt;
  work += now.work - before.work;
  gain += now.stored - before.stored;
  heat += 0.5 * dt * (before.dissipation + now.dissipation);
}

}  // namespace washtub
