#pragma once
#include <array>
#include <vector>

#include "base/archive.hpp"

namespace washtub {

/// Bounds of the range of strain from which on a cycle counts.
inline constexpr std::array<double, 3> strain_ranges = {0.001, 0.01, 0.05};

/// Counts how often signals go to and fro, whatever happens in between: closed cycles by the
/// rainflow rule (ASTM E1049-85, 5.4.4, in its form with four points). A cycle that is not yet
/// closed does not count.
class Rainflow {
 public:
  using Counts = std::array<double, strain_ranges.size()>;

  explicit Rainflow(std::size_t signals = 0) : turns_(signals) {}

  /// The next value of a signal.
  void add(std::size_t signal, double value);
  /// Cycles closed so far, of all signals, whose range is at least each of strain_ranges.
  const Counts& counts() const { return counts_; }
  /// Those that have closed since the last call of this.
  Counts take();
  std::size_t signals() const { return turns_.size(); }
  void state(Archive& archive);

 private:
  std::vector<std::vector<double>> turns_;  ///< of each signal, its last value being the last
  Counts counts_{}, taken_{};
};

}  // namespace washtub
