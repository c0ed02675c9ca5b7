#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

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
  double weight() const { return weight_; }  ///< sum of the weights
  double mean() const;
  double deviation() const;  ///< square root of the mean squared difference from the mean
  double rms() const;

 private:
  double weight_ = 0, mean_ = 0, squares_ = 0;
};

/// Mean of a series with its uncertainty.
struct MeanEstimate {
  double mean = 0;
  double half_width = 0;    ///< the mean is within +- this with 95 % confidence; NaN: unknown
  std::size_t batches = 0;  ///< averaged batches it rests on
};

/// Mean of a correlated, equally spaced series by the method of batch means: the series is cut into
/// equal contiguous batches, whose means are taken as independent, so that the half width is
/// Student's t times their standard deviation over sqrt(batches). It holds when a batch is longer
/// than the memory of the signal: for a washer let each batch be one or more whole cycles. The
/// mean is over the whole series; samples left over at the start belong to no batch. With fewer
/// than two batches, or fewer samples than batches, the half width is NaN.
MeanEstimate batch_means(std::span<const double> series, std::size_t batches = 8);

}  // namespace washtub
