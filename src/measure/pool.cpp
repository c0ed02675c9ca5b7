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

Pool pool(Members members) {
  Pool result;
  Statistics means, expected;  // of the members' means, and their squared errors by their cycles
  double freedom = 0;
  result.block = block_length(members);
  for (const auto& batches : members) {
    if (batches.empty()) continue;
    means.add(of(batches).mean());
    const Statistics own = of(blocks(batches, result.block));
    if (own.weight() < 2) continue;
    expected.add(error_squared(own));
    freedom += own.weight() - 1;
  }
  const double n = means.weight();
  result.members = static_cast<std::size_t>(n);
  result.mean = means.mean();
  result.deviation = n < 2 ? unknown : means.deviation() * std::sqrt(n / (n - 1));
  result.half_width = n < 2 ? unknown : student_95(n - 1) * result.deviation / std::sqrt(n);
  result.within = freedom > 0 ? student_95(freedom) * std::sqrt(expected.mean() / n) : unknown;
  result.ratio = result.deviation * result.deviation / expected.mean();
  result.chance = unknown;
  if (freedom > 0 && std::isfinite(result.ratio)) {
    const boost::math::fisher_f law(n - 1, freedom);
    result.chance = boost::math::cdf(boost::math::complement(law, result.ratio));
  }
  for (const auto& batches : members) {
    const double half_width = mean_of_batches(blocks(batches, result.block)).half_width;
    result.told += std::isfinite(half_width);
    result.hold += std::abs(of(batches).mean() - result.mean) <= half_width;
  }
  return result;
}

Drift drift(Members members) {
  double products = 0, squares = 0, longest = 0, freedom = -1;
  const auto for_each = [&](const auto& visit) {
    for (const auto& batches : members) {
      const double mean = of(batches).mean(),
                   middle = 0.5 * (static_cast<double>(batches.size()) - 1);
      for (std::size_t i = 0; i < batches.size(); ++i)
        visit(static_cast<double>(i) - middle, batches[i] - mean);
    }
  };
  for (const auto& batches : members) {
    if (batches.size() < 2) continue;
    longest = std::max(longest, static_cast<double>(batches.size()) - 1);
    freedom += static_cast<double>(batches.size()) - 1;
  }
  for_each([&](double time, double value) {
    products += time * value;
    squares += time * time;
  });
  if (!(squares > 0)) return {unknown, unknown};
  const double slope = products / squares;
  double rest = 0;
  for_each([&](double time, double value) { rest += std::pow(value - slope * time, 2); });
  const double error =
      freedom < 1 ? unknown : student_95(freedom) * std::sqrt(rest / freedom / squares);
  return {slope * longest, error * longest};
}

double count_for(double deviation, double wanted) {
  if (!(deviation >= 0 && wanted > 0)) return unknown;
  constexpr double most = 1e6;
  double n = std::max(2.0, std::ceil(std::pow(1.96 * deviation / wanted, 2)));
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
