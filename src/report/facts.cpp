#include "report/facts.hpp"

#include <fmt/format.h>

#include <cmath>

#include "case/description.hpp"
#include "case/groups.hpp"
#include "record/names.hpp"

namespace washtub {

using Json = nlohmann::ordered_json;

namespace {

/// "1 h 12 min", "97.3 s".
std::string duration(double seconds) {
  if (seconds < 120) return fmt::format("{:.3g} s", seconds);
  const double minutes = std::round(seconds / 60);
  if (minutes < 60) return fmt::format("{:.0f} min", minutes);
  return fmt::format("{:.0f} h {:.0f} min", std::floor(minutes / 60), std::fmod(minutes, 60));
}

std::string in_seconds(const char* name) { return std::string(name) + " [s]"; }

/// "16000 of 0.393 ms", "30003 of 0.11 to 0.157 ms".
std::string steps_text(const RunRecord& run, double steps) {
  const auto least = summary_number(run, {names::run, in_seconds(names::smallest_step)});
  const auto largest = summary_number(run, {names::run, in_seconds(names::largest_step)});
  std::string text = fmt::format("{:.0f}", steps);
  if (!least || !largest || !(*least <= *largest)) return text;
  if (*least < 0.999 * *largest)
    return text + fmt::format(" of {:.3g} to {:.3g} s", *least, *largest);
  return text + fmt::format(" of {:.3g} s", *largest);
}

/// The time that the run has reached, from its summary or else its history.
std::optional<double> reached(const RunRecord& run) {
  if (const auto end = summary_number(run, {names::run, in_seconds(names::end)})) return end;
  if (!run.history || run.history->rows() == 0) return {};
  return run.history->columns()[0].values.back();
}

/// What the run took.
std::vector<Fact> facts_of_run(const RunRecord& run) {
  std::vector<Fact> found;
  const auto add = [&](const std::string& key, auto&& text) {
    if (const auto value = summary_number(run, {names::run, key})) found.push_back(text(*value));
  };
  add(names::steps, [&](double n) { return Fact{"steps", steps_text(run, n)}; });
  add(in_seconds(names::wall_time), [](double t) { return Fact{"wall time", duration(t)}; });
  add(names::ranks, [](double n) { return Fact{"ranks", fmt::format("{:.0f}", n)}; });
  add(names::throughput, [](double rate) {
    return Fact{"throughput", fmt::format("{:.3g} million cell steps a second", rate)};
  });
  return found;
}

}  // namespace

Json facts(const RunRecord& run) {
  std::vector<Fact> all = {{"outcome", outcome(run)}};
  if (const auto time = reached(run))
    all.push_back({"time reached", fmt::format("{:.6g} s", *time)});
  if (run.definition)
    for (Fact& fact : describe(*run.definition)) all.push_back(std::move(fact));
  for (Fact& fact : facts_of_run(run)) all.push_back(std::move(fact));
  Json list = Json::array();
  for (const Fact& fact : all) list.push_back({{"name", fact.name}, {"value", fact.value}});
  return list;
}

Json groups(const RunRecord& run) {
  Json list = Json::array();
  if (!run.definition) return list;
  for (const Group& group : groups(*run.definition))
    list.push_back({{"name", group.name}, {"value", group.value}, {"meaning", group.meaning}});
  return list;
}

}  // namespace washtub
