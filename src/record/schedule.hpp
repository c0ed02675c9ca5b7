#pragma once
#include <vector>

#include "base/archive.hpp"
#include "case/case.hpp"

namespace washtub {

/// When a run has something to write: rows at the multiples of output.every, at the ends of the
/// statistics' window and of the drive's cycles in it, and at the end; frames at the first row from
/// each multiple of output.frames on. Times nearer to each other than a ten-thousandth of
/// output.every are one time, the ends of window, cycles and run before multiples.
class Schedule {
 public:
  explicit Schedule(const Case& whole);

  /// Time of the next row after t [s]; the end of the run where it is reached.
  double next(double t) const;
  /// Whether t is so near to `due` that what was due then is to be done.
  bool reached(double t, double due) const { return t > due - close_; }
  /// Whether a frame is due at the row at t; then the next one is due later.
  bool take_frame(double t);

  void state(Archive& archive) { archive.value("last frame", last_frame_); }

 private:
  double every_, frame_interval_, end_;
  double close_;               ///< [s]
  double merge_;               ///< [s]
  std::vector<double> marks_;  ///< ends of window and cycles, in order [s]
  double last_frame_ = 0;      ///< time of the last frame that was due [s]
};

}  // namespace washtub
