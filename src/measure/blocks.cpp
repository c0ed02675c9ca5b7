#include "measure/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace washtub {
namespace {

constexpr double one_sided = 1.645;  // 95 % point of the normal law
constexpr std::size_t least = 2;     // blocks of a run that are left

/// Correlation of neighbouring values and its standard error. That of n independent ones is -1/n on
/// average, since each deviates from the mean of all, which is taken off, with the variance
/// (n - 2)^2 / (n^2 (n - 1)) (Moran, Biometrika 35, 1948).
struct Correlation {
  double value = 0, error = 0;

  bool significant() const { return value > one_sided * error; }
};

Correlation neighbours(const std::vector<std::vector<double>>& members) {
  double products = 0, squares = 0, bias = 0, variance = 0, pairs = 0;
  for (const auto& values : members) {
    const auto n = static_cast<double>(values.size());
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
    for (std::size_t i = 0; i < values.size(); ++i) {
      squares += (values[i] - mean) * (values[i] - mean);
      if (i > 0) products += (values[i] - mean) * (values[i - 1] - mean);
    }
    if (values.size() < 2) continue;
    bias += (n - 1) / n;
    variance += (n - 1) * (n - 2) * (n - 2) / (n * n);
    pairs += n - 1;
  }
  if (!(squares > 0)) return {};
  return {products / squares + bias / pairs, std::sqrt(variance) / pairs};
}

}  // namespace

std::vector<double> blocks(std::span<const double> batches, std::size_t length) {
  std::vector<double> means;
  for (std::size_t i = batches.size() % length; i < batches.size(); i += length) {
    const auto block = batches.subspan(i, length);
    means.push_back(std::accumulate(block.begin(), block.end(), 0.0) / static_cast<double>(length));
  }
  return means;
}

std::size_t block_length(Members members) {
  std::size_t longest = 0;
  for (const auto& values : members) longest = std::max(longest, values.size());
  std::vector<std::vector<double>> merged;
  for (std::size_t length = 1;; length *= 2) {
    merged.clear();
    for (const auto& values : members) merged.push_back(blocks(values, length));
    if (longest / (2 * length) < least || !neighbours(merged).significant()) return length;
  }
}

std::vector<double> independent_blocks(const std::vector<double>& batches) {
  return blocks(batches, block_length({&batches, 1}));
}

}  // namespace washtub
