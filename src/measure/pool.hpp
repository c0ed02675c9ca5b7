#pragma once
#include <span>
#include <vector>

#include "measure/blocks.hpp"
#include "measure/cycles.hpp"

namespace washtub {

/// A quantity over several runs of one case that differ in their random start: each member's value
/// in its whole cycles, or in blocks of them that are independent (block_length()). Half widths are
/// 95 %, NaN where they cannot be told.
struct Pool {
  std::size_t members = 0;
  double mean = 0;        ///< of the members' values, each counting alike
  double half_width = 0;  ///< from the spread of the members' means, by Student's t
  double deviation = 0;   ///< standard deviation of the members' means
  double within = 0;      ///< half width that the cycles within the members would give the mean
  /// Variance of the members' means over what their cycles let expect; 1 on average where the
  /// cycles tell all, and the start does not matter.
  double ratio = 0;
  double chance = 0;      ///< that the ratio comes out as large or larger then (F test)
  std::size_t hold = 0;   ///< members whose own interval holds `mean`
  std::size_t told = 0;   ///< members with an interval of their own
  std::size_t block = 1;  ///< cycles that count as one value

  /// Whether the intervals of single runs cover the spread between them: not where the chance of
  /// that spread is below 5 %. Unknown is false for both.
  bool covered() const { return chance >= 0.05; }
  bool not_covered() const { return chance < 0.05; }
};

/// Searle, Casella & McCulloch, Variance Components (1992), ch. 3, for one random factor.
/// @param values   of the members; not always the means of their cycles, as of a root of mean
/// squares
/// @param batches  of each of them
Pool pool(std::span<const double> values, Members batches);

/// How a quantity changes from the first cycle to the last, of all members together: a straight
/// line through the deviations of their blocks from each member's mean. Members with fewer than two
/// do not count.
struct Drift {
  double change = 0;      ///< from the first cycle to the last of the longest member
  double half_width = 0;  ///< 95 %; NaN with fewer than one degree of freedom

  bool significant() const { return change > half_width || -change > half_width; }
};
Drift drift(Members batches);

/// Runs, or cycles of one run, whose mean would have a half width of `wanted`, from independent
/// values of this standard deviation: the least n with t(n - 1) deviation / sqrt(n) <= wanted.
double count_for(double deviation, double wanted);

/// Mean difference of values that belong together, b minus a, with Student's interval.
/// @pre as many of one as of the other
DifferenceEstimate paired(std::span<const double> a, std::span<const double> b);

}  // namespace washtub
