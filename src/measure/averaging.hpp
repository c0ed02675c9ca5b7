#pragma once
#include "measure/cycles.hpp"

namespace washtub {

/// What the statistics of a window rest on, in every file and page alike: the whole cycles of the
/// drive that are covered; where there is none, or no period, all that is covered.
struct Averaging {
  Interval over;                  ///< [s]; without length where nothing is covered
  std::size_t cycles = 0;         ///< whole ones that it holds; 0: it is what is covered
  std::vector<Interval> batches;  ///< whole_cycles()
};

Averaging averaging(const Interval& window, double covered, double period);

enum class Moment { mean, rms };

/// A statistic over a span and over each of its batches.
struct Statistic {
  double value = 0;             ///< NaN where no value is within
  std::vector<double> batches;  ///< those that are known
};

/// Of a column of history.csv: each value weighs with the time that it stands for, as over_span()
/// has it. A mean of powers times a period is the energy per cycle.
Statistic statistic(std::span<const double> times, std::span<const double> values,
                    const Averaging& averaging, Moment moment);

}  // namespace washtub
