#include "verify/judge.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/nearest.hpp"
#include "verify/series.hpp"

namespace washtub {
namespace {

using Json = nlohmann::json;

Json read_json(const std::string& path) {
  std::ifstream file(path);
  const Json json = Json::parse(file, nullptr, false);
  if (json.is_discarded()) throw InputError(fmt::format("{}: cannot be read", path));
  return json;
}

/// The number that a JSON pointer leads to; the nearest pointer to a number is named where it does
/// not lead to one.
double number_at(const std::string& path, const std::string& pointer) {
  const Json flat = read_json(path).flatten();
  if (flat.contains(pointer) && flat[pointer].is_number()) return flat[pointer].get<double>();
  std::vector<std::string> known;
  for (const auto& [key, value] : flat.items())
    if (value.is_number()) known.push_back(key);
  const std::string nearest = nearest_name(pointer, known);
  throw InputError(fmt::format("{}: no number at {}{}", path, quoted(pointer),
                               nearest.empty() ? "" : ", nearest: " + quoted(nearest)));
}

/// The file with the numbers of a run, or of an ensemble of them.
std::string summary_of(const std::string& directory) {
  const std::string pooled = directory + "/pooled.json";
  return std::filesystem::exists(pooled) ? pooled : directory + "/summary.json";
}

double frequency_at(const std::string& path, int mode) {
  const Json json = read_json(path);
  const auto list = json.find("frequencies [Hz]");
  const auto index = static_cast<std::size_t>(mode - 1);
  if (list == json.end() || index >= list->size())
    throw InputError(fmt::format("{}: no mode {}", path, mode));
  return (*list)[index].get<double>();
}

double measured_value(const CaseRuns& c, const Quantity& quantity) {
  std::vector<double> values;
  for (const std::string& run : quantity.used_runs())
    values.push_back(measured_number(quantity, c.runs[c.expected.run_index(run)]));
  return quantity.is_order() ? observed_order(values, quantity.refinement, quantity.exact)
                             : values[0];
}

/// What there is to say of a quantity whose runs are not all finished.
Judgement without_runs(const CaseRuns& c, const Quantity& quantity) {
  Judgement result;
  for (const std::string& name : quantity.used_runs()) {
    const RunResult& run = c.runs[c.expected.run_index(name)];
    if (run.state != RunState::failed) continue;
    result.verdict = quantity.decides ? Verdict::miss : Verdict::informative;
    result.note = fmt::format("run {} failed: {}", name, run.error);
  }
  return result;
}

Judgement judge(const CaseRuns& c, const Quantity& quantity) {
  for (const std::string& name : quantity.used_runs())
    if (!c.runs[c.expected.run_index(name)].finished()) return without_runs(c, quantity);
  try {
    return judge(quantity, measured_value(c, quantity));
  } catch (const InputError& error) {
    Judgement result;
    result.verdict = Verdict::miss;
    result.note = error.what();
    result.wrong_input = true;
    return result;
  }
}

}  // namespace

std::string name(Verdict verdict) {
  switch (verdict) {
    case Verdict::pass:
      return "pass";
    case Verdict::miss:
      return "MISS";
    case Verdict::known_miss:
      return "MISS, known";
    case Verdict::informative:
      return "informative";
    case Verdict::not_run:
      return "not run";
  }
  return "";
}

double reference(const Quantity& q) {
  if (!std::isnan(q.at_least)) return q.at_least;
  return std::isnan(q.at_most) ? q.value : q.at_most;
}

double tolerance(const Quantity& q) {
  return std::isnan(q.tolerance_percent) ? q.tolerance
                                         : std::abs(q.value) * q.tolerance_percent / 100;
}

Judgement judge(const Quantity& quantity, double measured) {
  Judgement result;
  result.measured = measured;
  result.deviation = measured - reference(quantity);
  bool good = std::abs(result.deviation) <= tolerance(quantity);
  if (!std::isnan(quantity.at_least)) good = result.deviation >= 0;
  if (!std::isnan(quantity.at_most)) good = result.deviation <= 0;
  result.verdict = good ? Verdict::pass : Verdict::miss;
  const double known = quantity.known_miss - reference(quantity);
  const double part = result.deviation / known;
  if (!good && part > 0 && part <= 1.1) result.verdict = Verdict::known_miss;
  if (good && !std::isnan(known)) result.note = "was known to miss, known_miss can go";
  if (!quantity.decides) result.verdict = Verdict::informative;
  if (std::isnan(measured)) result.note = "no number";
  return result;
}

double observed_order(const std::vector<double>& values, double refinement, double exact) {
  const bool three = values.size() == 3;
  const double coarse = three ? values[0] - values[1] : values[0] - exact;
  const double fine = three ? values[1] - values[2] : values[1] - exact;
  if (fine == 0 || (three && coarse * fine < 0)) return std::nan("");
  return std::log(std::abs(coarse / fine)) / std::log(refinement);
}

double measured_number(const Measured& what, const RunResult& run) {
  if (!what.summary.empty()) return number_at(summary_of(run.directory), what.summary) / what.per;
  if (what.mode > 0) return frequency_at(run.directory + "/modes.json", what.mode) / what.per;
  const CsvTable history = read_table(run.directory + "/history.csv");
  Series column = series(history, what.column, what.window);
  if (!what.minus.empty()) column = difference(column, series(history, what.minus, what.window));
  try {
    return take_of(what.take, column.times, column.values) / what.per;
  } catch (const InputError& error) {
    throw InputError(
        fmt::format("{}/history.csv: {}: {}", run.directory, what.column, error.what()));
  }
}

std::vector<Judgement> judge(const CaseRuns& c) {
  std::vector<Judgement> result;
  for (const Quantity& quantity : c.expected.quantities) result.push_back(judge(c, quantity));
  return result;
}

}  // namespace washtub
