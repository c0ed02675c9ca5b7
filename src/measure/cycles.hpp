#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "measure/statistics.hpp"

namespace washtub {

/// The whole cycles that fit into a window from its begin, as far as it is covered up to the time
/// `covered` [s]: the batches whose means count as independent. Without a period eight equal parts
/// of the covered window. None where nothing is covered, nor where there are over 1e5 of them.
std::vector<Interval> whole_cycles(const Interval& window, double covered, double period);

/// Moments over a span of time of a signal whose values stand for the time since the one before,
/// as in history.csv. The first value stands for no time, NaN is left out, and a value partly
/// inside counts in proportion. Times ascend.
Statistics over_span(std::span<const double> times, std::span<const double> values,
                     const Interval& span);

/// Mean of a signal with its uncertainty.
struct MeanEstimate {
  double mean = 0;
  double half_width = 0;    ///< the mean is within +- this with 95 % confidence; NaN: unknown
  std::size_t batches = 0;  ///< averaged batches it rests on
};

/// Mean of independent batches with the 95 % half width that Student's t gives; NaN with fewer than
/// two. Means over parts of a correlated signal count as independent when a part is longer than the
/// memory of the signal: for a washer, a whole cycle.
MeanEstimate mean_of_batches(std::span<const double> batches);

/// Difference of two means, b minus a.
struct DifferenceEstimate {
  double difference = 0;
  double half_width = 0;  ///< 95 %; NaN with fewer than two batches in one of them
  double freedom = 0;     ///< degrees of freedom
};

/// From the independent batches of both, which may scatter differently: Welch's method with the
/// degrees of freedom of Welch and Satterthwaite (Biometrika 34, 1947).
DifferenceEstimate welch(std::span<const double> a, std::span<const double> b);

/// Student's t for a 95 % interval (its 97.5 % point); freedom >= 1, need not be whole.
double student_95(double freedom);

}  // namespace washtub
