#include "report/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/cycles.hpp"
#include "record/names.hpp"

namespace washtub {
namespace {

constexpr double slip_bound = 0.05;    ///< of the largest speed
constexpr double strain_bound = 0.10;  ///< of an edge
constexpr double depth_bound = 0.1;    ///< of the smallest edge of a cell
constexpr double held_bound = 0.5;     ///< of that edge, for nodes that were held

/// Largest value of a column; none where it is missing or empty.
std::optional<double> largest(const RunRecord& run, const std::string& name) {
  const auto* column = run.history ? run.history->find(name) : nullptr;
  std::optional<double> most;
  if (column)
    for (const double value : column->values)
      if (!std::isnan(value)) most = std::max(value, most.value_or(value));
  return most;
}

/// From the summary, else the largest of the history's samples.
std::optional<double> extreme(const RunRecord& run, const std::vector<std::string>& names,
                              const std::string& column) {
  const auto number = summary_number(run, names);
  return number ? number : largest(run, column);
}

/// Largest ratio of slip and speed among the samples; where the water was nearly still, of slip and
/// a hundredth of its largest speed.
std::optional<double> sampled_slip(const RunRecord& run) {
  const auto* slip = run.history ? run.history->find(names::slip) : nullptr;
  const auto* speed = run.history ? run.history->find(names::speed) : nullptr;
  if (!slip || !speed || speed->values.empty()) return {};
  const double fastest = *std::max_element(speed->values.begin(), speed->values.end());
  if (fastest <= 0) return {};
  std::optional<double> most;
  for (std::size_t i = 0; i < slip->values.size(); ++i)
    most = std::max(slip->values[i] / std::max(speed->values[i], 0.01 * fastest), most.value_or(0));
  return most;
}

double smallest_cell_edge(const Case& whole) {
  double edge = std::numeric_limits<double>::infinity();
  for (int d = 0; d < whole.dimension; ++d)
    edge = std::min(edge, whole.domain.size[d] / whole.domain.cells[static_cast<std::size_t>(d)]);
  return edge;
}

using Sentences = std::vector<std::string>;

void warn_of_outcome(const RunRecord& run, Sentences& found) {
  const std::string how = outcome(run);
  if (how == "complete") return;
  if (how == "unfinished")
    found.push_back("The run has no end yet: what is shown is what there was when it was read.");
  else if (how == "stopped")
    found.push_back("The run was stopped before its end.");
  else
    found.push_back(fmt::format("An error ended the run: {}.", how));
}

void warn_of_window(const RunRecord& run, Sentences& found) {
  if (!run.definition || !run.history || run.history->rows() == 0) return;
  const OutputCase& output = run.definition->output;
  const double period = run.definition->scale.period;
  const double covered = run.history->columns()[0].values.back();
  const double begin = output.window_begin, end = output.window_end;
  if (covered <= begin) {
    found.push_back(fmt::format(
        "The run has reached {:.4g} s, the window of the statistics begins at {:.4g} s: there are "
        "no statistics.",
        covered, begin));
    return;
  }
  if (begin < 0.999 * period)
    found.push_back(
        fmt::format("The window of the statistics begins at {:.4g} s, in the first cycle after the "
                    "start: the means hold what is not yet settled.",
                    begin));
  const auto cycles = whole_cycles({begin, end}, covered, period).size();
  const double rounding = run.definition->time.fixed ? run.definition->time.step : 1e-6 * end;
  if (covered < end - rounding)
    found.push_back(fmt::format(
        "The run has reached {:.4g} s, the window of the statistics goes on to {:.4g} s.", covered,
        end));
  if (period > 0 && cycles < 2)
    found.push_back(fmt::format(
        "The window of the statistics holds {} of the drive: a mean has no interval of confidence "
        "with fewer than two.",
        cycles == 0 ? "no whole cycle" : "one whole cycle"));
  if (period > 0 && cycles == 2)
    found.emplace_back(
        "The window of the statistics holds two whole cycles only: intervals of confidence from "
        "two "
        "values are very wide.");
}

void warn_of_cloth(const RunRecord& run, Sentences& found) {
  const auto recorded = summary_number(run, {names::coupling, names::largest_slip_share});
  const auto slip = recorded ? recorded : sampled_slip(run);
  const auto usual = summary_number(run, {names::coupling, names::mean_slip_share});
  if (slip.value_or(0) > slip_bound)
    found.push_back(fmt::format(
        "The cloth slips through the water at up to {:.3g} % of the largest speed{}; below {:.0f} "
        "% is good. Shorter steps (time.step) lower it, or, where layers of cloth lie much nearer "
        "to "
        "each other than a cell, more domain.cells.",
        100 * *slip, usual ? fmt::format(", {:.2g} % on average", 100 * *usual) : "",
        100 * slip_bound));
  const auto strain = extreme(run, {names::coupling, names::strain}, names::strain);
  if (strain.value_or(0) > strain_bound)
    found.push_back(
        fmt::format("An edge of the cloth was strained by {:.3g} %; its stress is linear in "
                    "strain, which holds "
                    "below {:.0f} %.",
                    100 * *strain, 100 * strain_bound));
  if (!run.definition) return;
  const auto depth =
      summary_number(run, {names::coupling, std::string(names::penetration) + " [m]"});
  const double edge = smallest_cell_edge(*run.definition);
  if (depth.value_or(0) > depth_bound * edge)
    found.push_back(
        fmt::format("A node of the cloth was {:.2g} m inside a solid, {:.0f} % of a cell's edge; "
                    "below {:.0f} % is good.",
                    *depth, 100 * *depth / edge, 100 * depth_bound));
  const auto held = summary_number(run, {names::coupling, std::string(names::depth) + " [m]"});
  if (held.value_or(0) > held_bound * edge)
    found.push_back(fmt::format(
        "A node of the cloth would have gone {:.2g} m into a solid in one step, {:.0f} % of a "
        "cell's edge, had it not been held; below {:.0f} % is good. Shorter steps (time.cfl) lower "
        "it.",
        *held, 100 * *held / edge, 100 * held_bound));
}

void warn_of_pressure(const RunRecord& run, Sentences& found) {
  const auto failed = summary_number(run, {names::run, names::unconverged});
  const auto steps = summary_number(run, {names::run, names::steps});
  if (failed.value_or(0) > 0)
    found.push_back(fmt::format("The pressure did not converge in {:.0f}{} steps.", *failed,
                                steps ? fmt::format(" of {:.0f}", *steps) : ""));
  const auto divergence = extreme(run, {names::run, names::largest_divergence}, names::divergence);
  if (run.definition && divergence.value_or(0) > run.definition->solver.divergence * (1 + 1e-6))
    found.push_back(
        fmt::format("The divergence of the water reaches {:.2g} U/h, the solver's target {:.2g} "
                    "(solver.divergence).",
                    *divergence, run.definition->solver.divergence));
}

/// Share of the samples at which the Courant number, not time.step, set the step.
double share_of_short_steps(const RunRecord& run) {
  const auto* steps = run.history ? run.history->find(names::time_step) : nullptr;
  const auto* courant = run.history ? run.history->find(names::courant) : nullptr;
  const TimeCase& time = run.definition->time;
  if (!steps || !courant || time.fixed || time.step <= 0) return 0;
  std::size_t shorter = 0;
  for (std::size_t i = 0; i < steps->values.size(); ++i)
    shorter += steps->values[i] < 0.9 * time.step && courant->values[i] > 0.9 * time.cfl;
  return static_cast<double>(shorter) /
         static_cast<double>(std::max<std::size_t>(1, run.history->rows()));
}

void warn_of_steps(const RunRecord& run, Sentences& found) {
  if (!run.definition) return;
  const TimeCase& time = run.definition->time;
  const auto courant = extreme(run, {names::run, names::largest_courant}, names::courant);
  if (courant.value_or(0) > 1.01 * time.cfl)
    found.push_back(
        fmt::format("The largest Courant number is {:.3g}, above the limit of {:.3g} "
                    "(time.cfl){}.",
                    *courant, time.cfl, time.fixed ? ": the step is fixed" : ""));
  const double share = share_of_short_steps(run);
  if (share >= 0.01)
    found.push_back(fmt::format(
        "The Courant number kept the step below {:.3g} s (time.step) in {:.2g} % of the samples.",
        time.step, 100 * share));
}

/// What the run itself found.
void warn_of_quality(const RunRecord& run, Sentences& found) {
  const auto list = run.summary.is_object() ? run.summary.find(names::warnings) : run.summary.end();
  if (list == run.summary.end() || !list->is_array()) return;
  for (const auto& text : *list)
    if (text.is_string()) found.push_back(text);
}

void warn_of_case(const RunRecord& run, Sentences& found) {
  if (run.definition)
    for (const std::string& note : run.definition->notes) found.push_back(note + '.');
}

}  // namespace

nlohmann::ordered_json warnings(const RunRecord& run) {
  Sentences found;
  warn_of_outcome(run, found);
  warn_of_window(run, found);
  warn_of_quality(run, found);
  warn_of_cloth(run, found);
  warn_of_pressure(run, found);
  warn_of_steps(run, found);
  warn_of_case(run, found);
  return found;
}

}  // namespace washtub
