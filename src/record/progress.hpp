#pragma once
#include <string>

#include "base/archive.hpp"

namespace washtub {

/// The line a run shows while it works: on a terminal one that is overwritten, else a new one every
/// now and then; the same lines go to the log.
class Progress {
 public:
  /// `end`: simulated time at which the run ends [s].
  Progress(double end, bool shown);

  /// Seconds of computing since the start of the run, those before an interruption included.
  double elapsed() const;
  void state(Archive& archive);
  /// Shows `state` with the share done and the time to go, if it is time for another line.
  /// Returns whether it did.
  bool show(double time, const std::string& state);
  void finish() const;

 private:
  double end_, start_, next_ = 0;
  bool shown_, terminal_;
};

}  // namespace washtub
