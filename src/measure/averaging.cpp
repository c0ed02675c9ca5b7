#include "measure/averaging.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {

Averaging averaging(const Interval& window, double covered, double period) {
  Averaging result;
  result.batches = whole_cycles(window, covered, period);
  const double end = std::max(window.begin, std::min(window.end, covered));
  result.over = {window.begin, end};
  if (!(period > 0) || result.batches.empty()) return result;
  result.over.end = result.batches.back().end;
  result.cycles = result.batches.size();
  return result;
}

Statistic statistic(std::span<const double> times, std::span<const double> values,
                    const Averaging& averaging, Moment moment) {
  const auto over = [&](const Interval& span) {
    const Statistics found = over_span(times, values, span);
    return moment == Moment::rms ? found.rms() : found.mean();
  };
  Statistic result{over(averaging.over), {}};
  for (const Interval& batch : averaging.batches) {
    const double value = over(batch);
    if (std::isfinite(value)) result.batches.push_back(value);
  }
  return result;
}

}  // namespace washtub
