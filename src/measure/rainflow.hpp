#pragma once
#include <array>
#include <vector>

#include "base/archive.hpp"

namespace washtub {

/// Bounds of the range of strain from which on a cycle counts.
inline constexpr std::array<double, 3> strain_ranges = {0.001, 0.01, 0.05};

/// Counts how often signals go to and fro, whatever happens in between: cycles of the rainflow rule
/// (ASTM E1049-85, 5.4.4) whose range is at least a bound, half cycles counting half. They are half
/// of the reversals that are left when all smaller ones are taken out, which needs nothing of the
/// past but the last extreme and its direction.
class Rainflow {
 public:
  using Counts = std::array<double, strain_ranges.size()>;

  explicit Rainflow(std::size_t signals = 0);

  /// The next value of a signal.
  void add(std::size_t signal, double value);
  /// Cycles so far, of all signals, whose range is at least each of strain_ranges.
  const Counts& counts() const { return counts_; }
  /// Those since the last call of this.
  Counts take();
  std::size_t signals() const { return signals_; }
  void state(Archive& archive);

 private:
  static constexpr std::size_t bounds = strain_ranges.size();

  std::size_t signals_;
  std::vector<double> lowest_, highest_;  ///< since the last reversal, [signal][bound]
  std::vector<char> direction_;           ///< likewise: 1 up, -1 down, 0 not known yet
  std::vector<char> begun_;               ///< signals with a value
  Counts counts_{}, taken_{};
};

}  // namespace washtub
