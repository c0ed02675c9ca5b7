#pragma once
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace washtub {

/// What is taken of a series.
enum class Take {
  mean,  ///< over time
  rms,   ///< root of the time mean of the squares
  max,
  min,
  last,
  swing,       ///< max - min
  half_swing,  ///< half of it: the amplitude of an oscillation
  frequency,   ///< of the fitted oscillation [1/s], see fit_oscillation()
  decay,       ///< its rate a in exp(-a t) [1/s], negative where it grows
  slope        ///< of the least-squares line [1/s]
};

const std::vector<std::pair<std::string, Take>>& take_names();

/// `take` of the values at ascending times [s]. Means are those of the piecewise linear curve, so
/// that both ends of a whole period may be among the samples.
/// @throws InputError where there are too few samples for it
double take_of(Take take, std::span<const double> times, std::span<const double> values);

}  // namespace washtub
