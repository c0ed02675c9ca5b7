#pragma once
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "base/archive.hpp"

namespace washtub {

/// How long what is near stays near: of the pairs that are near at an instant, the share that is so
/// again a span of time later, mean over all pairs and instants.
class Persistence {
 public:
  using Pairs = std::vector<std::pair<int, int>>;

  /// @param span  [s]; 0: nothing is kept
  explicit Persistence(double span = 0) : span_(span) {}

  /// The pairs at an instant, in order; instants ascend.
  void add(double time, const Pairs& pairs);
  /// NaN where no pair is as old as the span.
  double share() const {
    return before_ > 0 ? still_ / before_ : std::numeric_limits<double>::quiet_NaN();
  }
  void state(Archive& archive);

 private:
  struct Instant {
    double time;
    Pairs pairs;
  };

  double span_;
  std::deque<Instant> kept_;  ///< those that are not yet as old as the span
  double before_ = 0;         ///< pairs a span ago, over all instants
  double still_ = 0;          ///< those that were near again
};

}  // namespace washtub
