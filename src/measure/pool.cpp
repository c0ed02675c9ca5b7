#include "measure/pool.hpp"

#include <algorithm>
#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace washtub {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

Statistics of(std::span<const double> values) {
  Statistics sum;
  for (const double value : values) sum.add(value);
  return sum;
}

/// Squared standard error of a mean of independent values.
double error_squared(const Statistics& values) {
  return values.deviation() * values.deviation() / (values.weight() - 1);
}

}  // namespace

Pool pool(std::span<const double> values, Members batches) {
  Pool result;
  result.block = block_length(batches);
  const Statistics means = of(values);
  Statistics expected;  // squared errors of the members by their cycles
  double freedom = 0;
  for (std::size_t m = 0; m < values.size(); ++m) {
    const auto own = blocks(batches[m], result.block);
    if (own.size() < 2) continue;
    expected.add(error_squared(of(own)));
    freedom += static_cast<double>(own.size()) - 1;
    ++result.told;
    result.hold += std::abs(values[m] - means.mean()) <= mean_of_batches(own).half_width;
  }
  const double n = means.weight();
  result.members = values.size();
  result.mean = means.mean();
  result.deviation = n < 2 ? unknown : means.deviation() * std::sqrt(n / (n - 1));
  result.half_width = n < 2 ? unknown : student_95(n - 1) * result.deviation / std::sqrt(n);
  result.within = freedom > 0 ? student_95(freedom) * std::sqrt(expected.mean() / n) : unknown;
  result.ratio = result.deviation * result.deviation / expected.mean();
  result.chance = unknown;
  if (std::isinf(result.ratio)) result.chance = 0;  // cycles that are all alike, and members not
  if (freedom > 0 && std::isfinite(result.ratio)) {
    const boost::math::fisher_f law(n - 1, freedom);
    result.chance = boost::math::cdf(boost::math::complement(law, result.ratio));
  }
  return result;
}

Drift drift(Members batches) {
  const std::size_t block = block_length(batches);
  std::vector<std::vector<double>> members;
  double longest = 0, freedom = -1;
  for (const auto& all : batches) {
    longest = std::max(longest, static_cast<double>(all.size()) - 1);
    members.push_back(blocks(all, block));
    if (members.back().size() > 1) freedom += static_cast<double>(members.back().size()) - 1;
  }
  const auto for_each = [&](const auto& visit) {
    for (const auto& values : members) {
      const double mean = of(values).mean(),
                   middle = 0.5 * (static_cast<double>(values.size()) - 1);
      for (std::size_t i = 0; i < values.size(); ++i)
        visit(static_cast<double>(i) - middle, values[i] - mean);
    }
  };
  double products = 0, squares = 0, rest = 0;
  for_each([&](double time, double value) {
    products += time * value;
    squares += time * time;
  });
  if (!(squares > 0)) return {unknown, unknown};
  const double slope = products / squares;
  for_each([&](double time, double value) { rest += std::pow(value - slope * time, 2); });
  const double error =
      freedom < 1 ? unknown : student_95(freedom) * std::sqrt(rest / freedom / squares);
  const double span = longest / static_cast<double>(block);
  return {slope * span, error * span};
}

double count_for(double deviation, double wanted) {
  if (!(deviation >= 0 && wanted > 0)) return unknown;
  constexpr double most = 1e6;
  double n = std::max(2.0, std::ceil(std::pow(1.9599 * deviation / wanted, 2)));
  while (n < most && student_95(n - 1) * deviation / std::sqrt(n) > wanted) ++n;
  return n;
}

DifferenceEstimate paired(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) throw std::logic_error("paired(): values without a partner");
  std::vector<double> differences;
  for (std::size_t i = 0; i < a.size(); ++i) differences.push_back(b[i] - a[i]);
  const MeanEstimate mean = mean_of_batches(differences);
  return {mean.mean, mean.half_width, static_cast<double>(a.size()) - 1};
}

}  // namespace washtub
