#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "case/groups.hpp"
#include "io/table.hpp"
#include "measure/averaging.hpp"
#include "record/declared.hpp"

namespace washtub {

/// Statistics of the columns of a history over the window of its case, see averaging(). None of a
/// column that is missing or has no value there.
class WindowedHistory {
 public:
  /// `owner`: the solid whose columns are meant, "" for those of the run.
  WindowedHistory(const Case& whole, const CsvTable& history, const std::string& owner = "");

  const Averaging& averaging() const { return averaging_; }
  std::optional<Statistic> mean(const std::string& column) const;
  std::optional<Statistic> rms(const std::string& column) const;
  std::optional<Statistic> rms_of_sum(const std::string& one, const std::string& other) const;
  /// Integral over every whole period [s]; none without a period.
  std::optional<Statistic> per_cycle(const std::string& column, double period) const;

 private:
  const std::vector<double>* find(const std::string& column) const;
  std::optional<Statistic> take(const std::vector<double>& values, const Averaging& averaging,
                                Moment moment) const;

  const CsvTable& history_;
  std::string owner_;
  const std::vector<double>& times_;
  Interval window_;
  Averaging averaging_;
};

/// A statistic as it is declared.
template <class Source>
struct DeclaredQuantity {
  Declared about;
  Scale scale;
  bool on_page;  ///< or in summary.json only
  std::optional<Statistic> (*take)(const Source&);
};

struct ClothHistory {
  WindowedHistory columns;
};
struct SolidHistory {
  WindowedHistory columns;
  const SolidCase& solid;
};

namespace quantities_of {
extern const std::vector<DeclaredQuantity<ClothHistory>> cloth;
extern const std::vector<DeclaredQuantity<SolidHistory>> solid;
}  // namespace quantities_of

/// A statistic over the window of a run.
struct RunQuantity {
  std::string name, unit;
  double mean = 0;  ///< over the whole cycles in the window; where none is covered, over what is
  std::vector<double> batches;  ///< its value in each whole cycle of the window
  std::string scale_name;       ///< "sigma_o"; "" where it or the case has no scale
  double scale = 1;             ///< [unit]
  std::string meaning = "";
  bool on_page = true;
  /// Of an ensemble: the seeds of the runs whose means the batches are.
  std::vector<std::uint64_t> seeds = {};

  /// Values that count as independent: blocks of the cycles, or the means of an ensemble's members.
  std::vector<double> independent() const;

  /// The true mean is within +- this with 95 % confidence, from the independent values by Student's
  /// t; none with fewer than two.
  std::optional<double> half_width() const;
};

/// Mean stress of the cloth and its parts, mean place of the pieces' centres. A batch is a whole
/// cycle of the drive, without one an eighth of the window. Quantities without a value are left
/// out.
std::vector<RunQuantity> cloth_quantities(const Case& whole, const CsvTable& history);
/// The same of one of several groups of cloth.
std::vector<RunQuantity> group_quantities(const Case& whole, const ClothCase& group,
                                          const CsvTable& history);
/// Rms torque of a solid and its parts; of one that turns mean power, and energy per cycle where it
/// turns in cycles.
std::vector<RunQuantity> solid_quantities(const Case& whole, const SolidCase& solid,
                                          const CsvTable& history);

}  // namespace washtub
