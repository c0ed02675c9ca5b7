#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/quantities.hpp"

namespace washtub {

/// A quantity of one run against that of the first run.
struct AgainstFirst {
  double difference = 0;             ///< [unit of the quantity]
  std::optional<double> half_width;  ///< 95 %, by Welch's method; none: cannot be told
  double percent = 0;                ///< the difference, of the first run's value
  /// Whether zero lies outside of difference +- half_width.
  std::optional<bool> significant() const;
};

/// A quantity of several runs; none where a run has it not.
struct CompareRow {
  std::string name, unit;
  std::vector<std::optional<RunQuantity>> values;    ///< one per run
  std::vector<std::optional<AgainstFirst>> against;  ///< one per run; none for the first, and where
                                                     ///< either lacks it or the first one's is 0
};

struct RunComparison {
  std::vector<std::string> names;  ///< of the runs
  std::vector<CompareRow> rows;
  std::vector<std::string> sentences;  ///< what differs, what does not, what cannot be told
};

/// Gives runs of the same name longer ones, "fast/wash" and "slow/wash", until all differ.
/// @throws InputError with fewer than two, with one directory twice, or where 2-D meets 3-D
void prepare_comparison(std::vector<RunRecord>& runs);

/// The quantities of the runs by name, and how the others differ from the first.
RunComparison compare(const std::vector<RunRecord>& runs);

/// As the page has it.
nlohmann::ordered_json to_json(const RunComparison& comparison);

}  // namespace washtub
