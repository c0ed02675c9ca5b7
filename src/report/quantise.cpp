#include "report/quantise.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

/// value/largest from 0 to 1.
double share(double value, double largest) {
  return std::isfinite(value) && largest > 0 ? std::clamp(value / largest, 0.0, 1.0) : 0;
}

}  // namespace

std::uint16_t quantise_linear(double value, double lower, double upper) {
  return static_cast<std::uint16_t>(std::lround(65535 * share(value - lower, upper - lower)));
}

std::uint16_t quantise_root(double value, double largest) {
  return static_cast<std::uint16_t>(std::lround(65535 * std::sqrt(share(value, largest))));
}

std::int8_t quantise_companded(double value, double largest) {
  const long q = std::lround(127 * std::sqrt(share(std::abs(value), largest)));
  return static_cast<std::int8_t>(value < 0 ? -q : q);
}

double largest_magnitude(std::span<const float> values) {
  float largest = 0;
  for (const float v : values)
    if (std::isfinite(v)) largest = std::max(largest, std::abs(v));
  return largest;
}

}  // namespace washtub
