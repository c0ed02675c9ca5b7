#include "report/quantities.hpp"

#include <algorithm>
#include <cmath>

#include "case/groups.hpp"
#include "measure/cycles.hpp"

namespace washtub {

using Json = nlohmann::ordered_json;

namespace {

/// Takes statistics of the columns of a run's history over its window: over the whole cycles in it
/// where there are any, so that means and batches rest on the same samples.
class Columns {
 public:
  explicit Columns(const RunRecord& run)
      : history_(*run.history), case_(*run.definition), times_(history_.columns()[0].values) {
    window_ = {case_.output.window_begin, case_.output.window_end};
    cycles_ = whole_cycles(window_, times_.back(), case_.scale.period);
  }

  /// Mean of a column; nothing where it is missing or has no value in the window.
  void add_mean(const std::string& column, const RunQuantity& about) {
    add(
        column, about, [](const Statistics& s) { return s.mean(); }, cycles_);
  }
  /// Root of its mean square.
  void add_rms(const std::string& column, const RunQuantity& about) {
    add(
        column, about, [](const Statistics& s) { return s.rms(); }, cycles_);
  }
  /// Integral over every whole period, from a column of power; nothing without a period.
  void add_energy(const std::string& column, const RunQuantity& about, double period) {
    if (!(period > 0)) return;
    const auto cycles = whole_cycles(window_, times_.back(), period);
    if (cycles.empty()) return;
    add(
        column, about, [&](const Statistics& s) { return s.mean() * period; }, cycles);
  }
  std::vector<RunQuantity> found;

 private:
  template <class Take>
  void add(const std::string& column, RunQuantity about, Take&& take,
           const std::vector<Interval>& cycles) {
    const auto* values = history_.find(column);
    if (!values) return;
    const Interval span =
        cycles.empty() ? window_ : Interval{cycles.front().begin, cycles.back().end};
    about.mean = take(over_span(times_, values->values, span));
    for (const Interval& cycle : cycles)
      about.batches.push_back(take(over_span(times_, values->values, cycle)));
    std::erase_if(about.batches, [](double value) { return !std::isfinite(value); });
    if (std::isfinite(about.mean)) found.push_back(std::move(about));
  }

  const CsvTable& history_;
  const Case& case_;
  const std::vector<double>& times_;
  Interval window_;
  std::vector<Interval> cycles_;
};

/// A quantity yet to be found, scaled where the case has scales.
RunQuantity wanted(const std::string& name, const std::string& unit, const std::string& scale_name,
                   std::optional<double> scale) {
  return {name, unit, 0, {}, scale ? scale_name : "", scale.value_or(1)};
}

void add_cloth(Columns& columns, const Case& whole) {
  const auto scale = scales(whole);
  const auto sigma = scale ? std::optional(scale->stress) : std::nullopt;
  for (const char* name : {"stress", "membrane stress", "bending stress"})
    columns.add_mean(name, wanted(name, "Pa", "sigma_o", sigma));
  columns.add_mean("cloth radius", {"cloth radius", "m", 0, {}, "r_o", whole.scale.length});
  if (whole.dimension == 3)
    columns.add_mean("cloth height", {"cloth height", "m", 0, {}, "H", whole.scale.height});
}

void add_solid(Columns& columns, const SolidCase& solid, const Case& whole) {
  const bool flat = whole.dimension == 2;
  const auto scale = scales(whole);
  const auto tau = scale ? std::optional(scale->torque) : std::nullopt;
  columns.add_rms(solid.name + " torque",
                  wanted(solid.name + " rms torque", flat ? "N m/m" : "N m", "tau_o", tau));
  if (!solid.drive.moving()) return;
  const std::string power = solid.name + " power";
  columns.add_mean(power, {solid.name + " mean power", flat ? "W/m" : "W", 0, {}, "", 1});
  columns.add_energy(power, {solid.name + " energy per cycle", flat ? "J/m" : "J", 0, {}, "", 1},
                     solid.drive.period());
}

/// The scatter needs all points of the cloth at all samples, which only the run itself has.
void add_scatter(std::vector<RunQuantity>& found, const RunRecord& run) {
  for (const char* about : {"the common centre", "each piece's own centre"}) {
    const auto length = run.definition ? std::optional(run.definition->scale.length) : std::nullopt;
    RunQuantity quantity = wanted("scatter about " + std::string(about), "m", "r_o", length);
    const auto mean = summary_number(run, {"cloth", quantity.name + " [m]"});
    if (!mean) continue;
    quantity.batches = summary_numbers(run, {"cloth", quantity.name + " in each cycle [m]"});
    Statistics cycles;
    for (const double value : quantity.batches) cycles.add(value);
    quantity.mean = quantity.batches.empty() ? *mean : cycles.rms();
    found.push_back(std::move(quantity));
  }
}

}  // namespace

std::optional<double> RunQuantity::half_width() const {
  const double width = mean_of_batches(batches).half_width;
  return std::isfinite(width) ? std::optional(width) : std::nullopt;
}

std::vector<RunQuantity> find_quantities(const RunRecord& run) {
  std::vector<RunQuantity> found;
  if (run.definition && run.history && run.history->rows() > 1) {
    const Case& whole = *run.definition;
    Columns columns(run);
    if (!whole.cloth.empty()) add_cloth(columns, whole);
    for (const SolidCase& solid : whole.solids) add_solid(columns, solid, whole);
    found = std::move(columns.found);
  }
  add_scatter(found, run);
  return found;
}

Json to_json(const RunQuantity& quantity) {
  const auto width = quantity.half_width();
  const auto optional = [](std::optional<double> value) { return value ? Json(*value) : Json(); };
  Json json = {{"name", quantity.name},
               {"unit", quantity.unit},
               {"mean", quantity.mean},
               {"half_width", optional(width)},
               {"batches", quantity.batches.size()},
               {"scaled", nullptr}};
  if (quantity.scale_name.empty()) return json;
  json["scaled"] = {{"mean", quantity.mean / quantity.scale},
                    {"half_width", width ? Json(*width / quantity.scale) : Json()},
                    {"by", quantity.scale_name}};
  return json;
}

Json quantities(const RunRecord& run) {
  Json list = Json::array();
  for (const RunQuantity& quantity : find_quantities(run)) list.push_back(to_json(quantity));
  return list;
}

}  // namespace washtub
