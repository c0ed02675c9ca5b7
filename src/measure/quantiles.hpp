#pragma once
#include <array>
#include <vector>

namespace washtub {

/// A value and its weight.
struct Weighted {
  double value, weight;
};

/// For each part the smallest value that this part of the whole weight does not exceed; NaN where
/// there are none. Sorts the values.
template <std::size_t N>
std::array<double, N> quantiles(std::vector<Weighted>& values, const std::array<double, N>& parts);

}  // namespace washtub
