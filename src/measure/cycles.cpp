#include "measure/cycles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace washtub {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Integral of cos^power from 0 to `angle` by Simpson's rule.
double cosine_integral(double power, double angle) {
  constexpr int intervals = 400;
  const double step = angle / intervals;
  double sum = 0;
  for (int i = 0; i <= intervals; ++i) {
    const double weight = i == 0 || i == intervals ? 1 : i % 2 == 1 ? 4 : 2;
    sum += weight * std::pow(std::cos(i * step), power);
  }
  return sum * step / 3;
}

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

/// With t = sqrt(n) tan(x) the density goes as cos^(n-1)(x), so that Newton's method finds the
/// angle within which 95 % of its integral lies.
double student_95(double freedom) {
  const double half = 0.5 * std::sqrt(std::numbers::pi) *
                      std::exp(std::lgamma(freedom / 2) - std::lgamma((freedom + 1) / 2));
  double angle = std::atan(1.96 / std::sqrt(freedom));
  for (int i = 0; i < 30; ++i)
    angle -= (cosine_integral(freedom - 1, angle) - 0.95 * half) /
             std::pow(std::cos(angle), freedom - 1);
  return std::sqrt(freedom) * std::tan(angle);
}

}  // namespace washtub
