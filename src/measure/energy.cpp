#include "measure/energy.hpp"

#include <limits>

#include "measure/cycles.hpp"

namespace washtub {

double work(std::span<const TorqueSample> samples, const Interval& window) {
  double sum = 0;
  for (const TorqueSample& s : samples)
    if (s.over.length() > 0) sum += s.impulse * s.speed * window.overlap(s.over) / s.over.length();
  return sum;
}

double mean_power(std::span<const TorqueSample> samples, const Interval& window) {
  double time = 0;
  for (const TorqueSample& s : samples) time += window.overlap(s.over);
  return time > 0 ? work(samples, window) / time : std::numeric_limits<double>::quiet_NaN();
}

std::vector<double> energy_per_cycle(std::span<const TorqueSample> samples, const Interval& window,
                                     double period) {
  std::vector<double> energies;
  if (samples.empty() || !(period > 0)) return energies;
  if (samples.front().over.begin > window.begin + 1e-9 * period) return energies;
  for (const Interval& cycle : whole_cycles(window, samples.back().over.end, period))
    energies.push_back(work(samples, cycle));
  return energies;
}

}  // namespace washtub
