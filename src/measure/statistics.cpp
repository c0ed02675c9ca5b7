#include "measure/statistics.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace washtub {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// 97.5 % point of Student's distribution; to 0.2 % above 12 degrees of freedom.
double student_95(std::size_t freedom) {
  constexpr std::array<double, 12> table = {12.706, 4.303, 3.182, 2.776, 2.571, 2.447,
                                            2.365,  2.306, 2.262, 2.228, 2.201, 2.179};
  if (freedom <= table.size()) return table[freedom - 1];
  const double n = static_cast<double>(freedom);
  return 1.960 + 2.372 / n + 2.82 / (n * n);
}

double mean_of(std::span<const double> values) {
  Statistics s;
  for (const double v : values) s.add(v);
  return s.mean();
}

}  // namespace

void Statistics::add(double value, double weight) {
  if (!(weight > 0)) return;
  weight_ += weight;
  const double from_old = value - mean_;
  mean_ += from_old * weight / weight_;
  squares_ += weight * from_old * (value - mean_);
}

double Statistics::mean() const { return weight_ > 0 ? mean_ : unknown; }

double Statistics::deviation() const {
  return weight_ > 0 ? std::sqrt(squares_ / weight_) : unknown;
}

double Statistics::rms() const { return std::hypot(mean(), deviation()); }

MeanEstimate batch_means(std::span<const double> series, std::size_t batches) {
  MeanEstimate estimate{mean_of(series), unknown, batches};
  if (batches < 2 || series.size() < batches) return estimate;
  const std::size_t length = series.size() / batches;
  const auto used = series.last(length * batches);
  Statistics means;
  for (std::size_t b = 0; b < batches; ++b) means.add(mean_of(used.subspan(b * length, length)));
  const double freedom = static_cast<double>(batches - 1);
  estimate.half_width = student_95(batches - 1) * means.deviation() / std::sqrt(freedom);
  return estimate;
}

}  // namespace washtub
