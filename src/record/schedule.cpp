#include "record/schedule.hpp"

#include <algorithm>
#include <cmath>

#include "measure/cycles.hpp"

namespace washtub {
namespace {

constexpr double one_time = 1e-4;  // of output.every, within which two times are one

}  // namespace

Schedule::Schedule(const Case& whole)
    : every_(whole.output.every),
      frame_interval_(whole.output.frames),
      end_(whole.time.end),
      close_(whole.time.fixed ? 0.5 * whole.time.step : 1e-9 * every_),
      merge_(one_time * every_) {
  const Interval window{whole.output.window_begin, whole.output.window_end};
  marks_ = {window.begin, window.end};
  if (whole.scale.period > 0)
    for (const Interval& cycle : whole_cycles(window, window.end, whole.scale.period))
      marks_.push_back(cycle.end);
  std::sort(marks_.begin(), marks_.end());
}

double Schedule::next(double t) const {
  const double past = t + std::max(close_, merge_);
  double due = end_;
  const double multiple = every_ * (std::floor(past / every_) + 1);
  if (multiple < end_ - merge_) due = multiple;
  const auto mark = std::upper_bound(marks_.begin(), marks_.end(), past);
  if (mark != marks_.end() && *mark < due + merge_ && *mark < end_ - merge_) due = *mark;
  return due;
}

bool Schedule::take_frame(double t) {
  if (frame_interval_ <= 0) return false;
  const auto multiples = [&](double time) {
    return std::floor((time + std::max(close_, merge_)) / frame_interval_);
  };
  if (multiples(t) <= multiples(last_frame_)) return false;
  last_frame_ = t;
  return true;
}

}  // namespace washtub
