#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "report/run_record.hpp"

namespace washtub {

/// A statistic over the window of a run.
struct RunQuantity {
  std::string name, unit;
  double mean = 0;  ///< over the whole cycles in the window; where none is covered, over what is
  std::vector<double> batches;  ///< its value in each whole cycle of the window
  std::string scale_name;       ///< "sigma_o"; "" where it or the case has no scale
  double scale = 1;             ///< [unit]

  /// The true mean is within +- this with 95 % confidence, from the batches by Student's t; none
  /// with fewer than two.
  std::optional<double> half_width() const;
};

/// From history.csv: mean stress of the cloth and its parts, mean place of the pieces' centres,
/// rms torque of every solid, mean power of those that turn, and energy per cycle of those that
/// turn in cycles. A batch is a whole cycle of the drive, without one an eighth of the window. From
/// the summary: the scatter of the cloth. Names of solids come first: "agitator rms torque".
/// Quantities without a value are left out, all of them where the window is not known.
std::vector<RunQuantity> find_quantities(const RunRecord& run);

/// As the page has it.
nlohmann::ordered_json to_json(const RunQuantity& quantity);

/// All of them, as the page has them.
nlohmann::ordered_json quantities(const RunRecord& run);

}  // namespace washtub
