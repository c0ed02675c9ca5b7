#include "measure/energy.hpp"

#include <limits>

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

std::vector<double> energy_per_cycle(std::span<const TorqueSample> samples, double start,
                                     double period) {
  std::vector<double> energies;
  if (samples.empty() || !(period > 0)) return energies;
  const double slack = 1e-9 * period;
  if (samples.front().over.begin > start + slack) return energies;
  for (Interval cycle{start, start + period}; cycle.end <= samples.back().over.end + slack;) {
    energies.push_back(work(samples, cycle));
    const double cycles = static_cast<double>(energies.size());
    cycle = {start + cycles * period, start + (cycles + 1) * period};
  }
  return energies;
}

}  // namespace washtub
