#pragma once
#include <array>

#include "base/parallel.hpp"

namespace washtub {

/// Sums and maxima that are found over all ranks together.
struct Tally {
  std::array<double, 4> sum{}, max{};
};

/// Replaces every entry by its sum or maximum over the ranks, in one message (collective).
void combine(const Parallel& parallel, Tally& tally);

}  // namespace washtub
