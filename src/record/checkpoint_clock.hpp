#pragma once
#include <chrono>

#include "case/case.hpp"

namespace washtub {

/// When a checkpoint is due: some simulated time or some time of computing after the last one.
class CheckpointClock {
 public:
  explicit CheckpointClock(const CheckpointCase& intervals) : intervals_(intervals) {}

  /// A checkpoint was written at the simulated time t [s].
  void start(double t) { written_ = t, began_ = Clock::now(); }
  bool due(double t) const {
    const std::chrono::duration<double> computing = Clock::now() - began_;
    return (intervals_.every > 0 && t - written_ > (1 - 1e-9) * intervals_.every) ||
           (intervals_.wall_time > 0 && computing.count() > intervals_.wall_time);
  }

 private:
  using Clock = std::chrono::steady_clock;
  CheckpointCase intervals_;
  double written_ = 0;
  Clock::time_point began_ = Clock::now();
};

}  // namespace washtub
