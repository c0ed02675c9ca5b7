#include "measure/cloth_statistics.hpp"

#include "measure/cycles.hpp"

namespace washtub {

ClothStatistics::ClothStatistics(std::size_t pieces, const Interval& window, double period,
                                 const Vec<2>& axis)
    : pieces_(pieces),
      axis_(axis),
      spans_(whole_cycles(window, window.end, period)),
      batches_(spans_.size()),
      whole_(batches_ > 0 && period > 0),
      ended_(pieces, window),
      open_(part(batches_ > 0 ? spans_.front() : window)) {
  if (batches_ == 0 || whole_) spans_.push_back({open_end(), window.end});
}

/// Where the part of the window begins that has no end of a cycle.
double ClothStatistics::open_end() const {
  return batches_ > 0 ? spans_.back().end : open_.scatter.window().begin;
}

ClothStatistics::Part ClothStatistics::part(const Interval& span) const {
  return {StressStatistics(pieces_, span), Scatter(pieces_, span, axis_)};
}

void ClothStatistics::close() {
  ended_.add(open_.stress);
  cycles_.push_back(open_.scatter);
  open_ = next();
}

void ClothStatistics::state(Archive& archive) {
  long ended = static_cast<long>(cycles_.size());
  archive.value("cycles that have ended", ended);
  if (archive.reading()) {
    cycles_.clear();
    while (static_cast<long>(cycles_.size()) < ended) cycles_.push_back(next().scatter);
    open_ = next();
  }
  archive.value("ended", ended_);
  archive.value("cycle", cycles_);
  archive.value("open", open_);
}

ClothStatistics::Part ClothStatistics::all() const {
  Part sum = part({spans_.front().begin, spans_.back().end});
  sum.stress.add(ended_);
  for (const Scatter& cycle : cycles_) sum.scatter.add(cycle);
  if (whole_ && !cycles_.empty()) return sum;
  sum.stress.add(open_.stress);
  sum.scatter.add(open_.scatter);
  return sum;
}

}  // namespace washtub
