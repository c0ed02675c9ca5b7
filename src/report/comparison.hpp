#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/statistics.hpp"

namespace washtub {

/// A quantity of one run against that of the first run.
struct AgainstFirst {
  /// [unit of the quantity]; 0 also where it is less than 1e-6 of the values: they are the same
  double difference = 0;
  bool paired = false;  ///< it is the mean of differences between runs of the same seed
  /// 95 %; none: cannot be told. By Welch's method, or, between ensembles of the
  /// same seeds, from the differences of the runs that start alike.
  std::optional<double> half_width;
  bool relative = true;  ///< whether the first run's value is more than rounding
  double percent = 0;    ///< the difference, of the first run's value; 0 if not relative
  /// Whether zero lies outside of difference +- half_width.
  std::optional<bool> significant() const;
};

/// A quantity of several runs; none where a run has it not.
struct CompareRow {
  std::string name, unit;
  std::vector<std::optional<RunQuantity>> values;    ///< one per run
  std::vector<std::optional<AgainstFirst>> against;  ///< one per run; none for the first, and where
                                                     ///< either lacks it
};

/// A run with its quantities, or an ensemble of runs; then `run` is its first member.
struct Compared {
  std::string directory, name;
  RunRecord run;
  std::vector<RunQuantity> quantities;
  std::size_t members = 1;

  explicit Compared(RunRecord run);
  Compared(std::string directory, std::string name, RunRecord first,
           std::vector<RunQuantity> quantities, std::size_t members);
};

struct RunComparison {
  std::vector<std::string> names;  ///< of the runs
  std::vector<CompareRow> rows;
  std::vector<std::string> sentences;  ///< what differs, what does not, what cannot be told
};

/// Gives what has the same name longer ones, "fast/wash" and "slow/wash", until all differ.
/// @throws InputError with fewer than two, with one directory twice, or where 2-D meets 3-D
void prepare_comparison(std::vector<Compared>& all);

/// A number down to the second digit of `width`: "12.30" for a width of 0.21, "168000" for 25000;
/// four digits where the width is not known.
std::string as_exact(double value, std::optional<double> width);

/// The quantities by name, and how the others differ from the first.
RunComparison compare(const std::vector<Compared>& all);

/// As the page has it.
nlohmann::ordered_json to_json(const RunComparison& comparison);

}  // namespace washtub
