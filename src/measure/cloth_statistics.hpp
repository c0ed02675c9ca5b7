#pragma once
#include <vector>

#include "measure/scatter.hpp"
#include "measure/stress.hpp"

namespace washtub {

/// Stress and scatter of all pieces of cloth while samples come: over the same span as averaging()
/// of the same window says. What they need of the past is one sum for each piece, and the scatter
/// of each cycle.
class ClothStatistics {
 public:
  ClothStatistics(std::size_t pieces, const Interval& window, double period, const Vec<2>& axis);

  /// What is collected between two ends of cycles.
  struct Part {
    StressStatistics stress;
    Scatter scatter;

    void state(Archive& archive) {
      archive.value("stress", stress);
      archive.value("scatter", scatter);
    }
  };
  /// Calls add(part) for every part of the window that the time `over` reaches into, in order; a
  /// part weighs what is added to it by the time that they share.
  template <class Add>
  void add(const Interval& over, const Add& add) {
    while (over.end > open_.scatter.window().begin && goes_on()) {
      add(open_);
      if (over.end < open_.scatter.window().end - slack() || cycles_.size() >= batches_) return;
      close();
    }
  }

  void state(Archive& archive);

  /// Over the whole cycles that have ended; over all there is where none has, or without a period.
  Part all() const;
  /// Of each whole cycle that has ended; without a period of each eighth of the window.
  std::span<const Scatter> cycles() const { return cycles_; }

 private:
  Part part(const Interval& span) const;
  bool goes_on() const { return cycles_.size() < spans_.size(); }
  Part next() const { return part(goes_on() ? spans_[cycles_.size()] : Interval{}); }
  double slack() const { return 1e-6 * open_.scatter.window().length(); }  ///< of whole_cycles()
  void close();
  double open_end() const;

  std::size_t pieces_;
  Vec<2> axis_;
  std::vector<Interval> spans_;  ///< cycles, and what is left of the window behind them
  std::size_t batches_;          ///< how many of them end
  bool whole_;                   ///< they are cycles, and what comes after them does not count
  StressStatistics ended_;       ///< over those that have ended
  std::vector<Scatter> cycles_;  ///< over each of those
  Part open_;                    ///< over what there is of the one that goes on
};

}  // namespace washtub
