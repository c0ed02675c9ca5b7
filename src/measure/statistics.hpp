#pragma once
#include <algorithm>

namespace washtub {

/// A span of time [s]: a window of averaging, or the time for which a sample stands.
struct Interval {
  double begin = 0, end = 0;
  double length() const { return end - begin; }
  /// Time shared with another span [s]; the weight of a sample in a window.
  double overlap(const Interval& other) const {
    return std::max(0.0, std::min(end, other.end) - std::max(begin, other.begin));
  }
};

/// Weighted mean, standard deviation and rms of a signal, one pass and free of cancellation
/// (Welford; weights after West, Commun. ACM 22, 1979). With times as weights these are the
/// moments over time, whatever the sampling. All NaN before the first positive weight.
class Statistics {
 public:
  void add(double value, double weight = 1);
  void add(const Statistics& others);        ///< all values that those have seen
  double weight() const { return weight_; }  ///< sum of the weights
  double mean() const;
  double deviation() const;  ///< square root of the mean squared difference from the mean
  double rms() const;

  static constexpr bool of_doubles = true;

 private:
  double weight_ = 0, mean_ = 0, squares_ = 0;
};

}  // namespace washtub
