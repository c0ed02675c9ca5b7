#include "measure/cycles.hpp"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <limits>

namespace washtub {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Mean and variance of the mean of batches.
struct Batches {
  explicit Batches(std::span<const double> values)
      : freedom(static_cast<double>(values.size()) - 1) {
    for (const double value : values) all.add(value);
    const double deviation = all.deviation();
    variance = freedom > 0 ? deviation * deviation / freedom : unknown;
  }
  Statistics all;
  double freedom, variance;
};

}  // namespace

std::vector<Interval> whole_cycles(const Interval& window, double covered, double period) {
  constexpr double parts = 8, most = 1e5;
  const double end = std::min(window.end, covered);
  if (!(end > window.begin)) return {};
  const double length = period > 0 ? period : (end - window.begin) / parts;
  const double count = period > 0 ? std::floor((end - window.begin) / period + 1e-6) : parts;
  std::vector<Interval> cycles;
  for (double i = 0; count <= most && i < count; ++i)
    cycles.push_back({window.begin + i * length, window.begin + (i + 1) * length});
  return cycles;
}

Statistics over_span(std::span<const double> times, std::span<const double> values,
                     const Interval& span) {
  Statistics result;
  const auto first = std::upper_bound(times.begin(), times.end(), span.begin);
  for (auto i = static_cast<std::size_t>(std::max(first - times.begin(), 1L)); i < times.size();
       ++i) {
    if (times[i - 1] >= span.end) break;
    if (!std::isnan(values[i])) result.add(values[i], span.overlap({times[i - 1], times[i]}));
  }
  return result;
}

MeanEstimate mean_of_batches(std::span<const double> batches) {
  const Batches all(batches);
  const double half_width =
      batches.size() < 2 ? unknown : student_95(all.freedom) * std::sqrt(all.variance);
  return {all.all.mean(), half_width, batches.size()};
}

DifferenceEstimate welch(std::span<const double> a, std::span<const double> b) {
  const Batches first(a), second(b);
  DifferenceEstimate result{second.all.mean() - first.all.mean(), unknown, unknown};
  if (a.size() < 2 || b.size() < 2) return result;
  const double variance = first.variance + second.variance;
  result.freedom = variance > 0 ? variance * variance /
                                      (first.variance * first.variance / first.freedom +
                                       second.variance * second.variance / second.freedom)
                                : first.freedom + second.freedom;
  result.half_width = student_95(result.freedom) * std::sqrt(variance);
  return result;
}

double student_95(double freedom) {
  return boost::math::quantile(
      boost::math::complement(boost::math::students_t(freedom), 0.5 * (1 - 0.95)));
}

}  // namespace washtub
