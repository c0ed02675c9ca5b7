#pragma once
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/table.hpp"
#include "verify/level.hpp"
#include "verify/take.hpp"

namespace washtub {

/// A run of a verification case.
struct RunSpec {
  std::string name;
  VerifyLevel level = VerifyLevel::quick;
  std::string file = "case.toml";  ///< beside expected.toml
  std::string command = "run";     ///< or "modes"
  std::string seeds;               ///< of an ensemble of runs; "" = a single run
  std::vector<std::string> settings;
  double cost = 0;  ///< about how long it takes [s]; 0 = not known
};

/// A number that a run has computed.
struct Measured {
  std::string column, minus;  ///< of history.csv; the second is taken off the first
  Take take = Take::last;
  std::array<double, 2> window{0, std::numeric_limits<double>::infinity()};  ///< [s]
  double per = 1;
  std::string summary;  ///< JSON pointer into summary.json, of an ensemble into pooled.json
  int mode = 0;         ///< natural frequency of a modes run, from 1; 0 = none of it
};

/// A number to be judged.
struct Quantity : Measured {
  std::string name, unit, source;
  std::string run;  ///< or, for an order of convergence, runs from coarse to fine
  std::vector<std::string> runs;
  double refinement = 2, exact = 0;
  double value = std::nan(""), tolerance = std::nan(""), tolerance_percent = std::nan("");
  double at_least = std::nan(""), at_most = std::nan("");
  double known_miss = std::nan("");  ///< what is measured where it is known to miss
  bool decides = true;

  bool is_order() const { return !runs.empty(); }
  std::vector<std::string> used_runs() const {
    return is_order() ? runs : std::vector<std::string>{run};
  }
};

/// A line of a figure: a column over time (`run`), a number of each of several runs (`runs` over
/// `x`), or given points (`values` over `x`).
struct Curve : Measured {
  std::string label, run;
  std::vector<std::string> runs;
  std::vector<double> x, values;
};

enum class FigureKind { history, convergence };

struct Figure {
  std::string name, caption, x_label, y_label;
  FigureKind kind = FigureKind::history;
  std::vector<double> lines;   ///< horizontal lines of reference
  std::vector<double> slopes;  ///< powers drawn beside a convergence
  std::vector<Curve> curves;
};

/// expected.toml: what a verification case runs and what it must give.
struct Expected {
  std::string name;       ///< of the case: that of its folder
  std::string directory;  ///< the folder
  std::string title, about;
  std::vector<RunSpec> runs;
  std::vector<Quantity> quantities;
  std::vector<Figure> figures;

  /// Position of a run. @pre there is one of that name
  std::size_t run_index(const std::string& run) const;
  /// The highest level of the runs that a quantity needs.
  VerifyLevel level_of(const Quantity& quantity) const;
};

const Table<Expected>& expected_table();

/// Reads `directory`/expected.toml. @throws InputError with line, key and what is allowed
Expected read_expected(const std::string& directory);

/// Refuses what no single key shows: names given twice, runs that are not there, quantities
/// without a criterion. `root` is what `expected` was read from.
/// @throws InputError
void check_expected(const Expected& expected, const Node& root);

/// Names of the folders in `directory` that hold an expected.toml, in alphabetical order.
/// @throws InputError where the directory has none
std::vector<std::string> case_names(const std::string& directory);

}  // namespace washtub
