#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "app/commands.hpp"
#include "app/launch.hpp"
#include "app/mpi.hpp"
#include "app/ranks.hpp"
#include "case/case.hpp"
#include "case/description.hpp"
#include "case/groups.hpp"
#include "record/forecast.hpp"
#include "washer/build.hpp"
#include "washer/resolution.hpp"

namespace washtub {
namespace {

/// Text at a column, or two spaces further on where what stands before it reaches there.
std::string columns(const std::string& name, std::size_t column, const std::string& text) {
  return fmt::format("{:<{}}{}", name, std::max(column, name.size() + 2), text);
}

void print_line(const std::string& name, const std::string& text) {
  fmt::print("{}\n", columns(name, 13, text));
}

/// "Re = 1208   density omega_max r_o^2 / viscosity", one line each.
void print_groups(const Case& whole) {
  std::string name = "groups";
  for (const Group& group : groups(whole)) {
    const bool large = group.value >= 1000 && group.value < 1e6;
    const std::string value =
        large ? fmt::format("{:.0f}", group.value) : fmt::format("{:.3g}", group.value);
    print_line(name, columns(group.name + " = " + value, 18, group.meaning));
    name.clear();
  }
}

/// "3.2 s", "14 min", "5.1 h"
std::string duration(double seconds) {
  if (seconds < 99) return fmt::format("{:.2g} s", seconds);
  if (seconds < 5900) return fmt::format("{:.2g} min", seconds / 60);
  return fmt::format("{:.2g} h", seconds / 3600);
}

/// "3.2 MB"
std::string size(double bytes) {
  if (bytes < 1e6) return fmt::format("{:.0f} kB", std::ceil(bytes / 1e3));
  if (bytes < 999e6) return fmt::format("{:.3g} MB", bytes / 1e6);
  return fmt::format("{:.3g} GB", bytes / 1e9);
}

void print_forecast(const Forecast& forecast, int ranks) {
  if (!forecast.failure.empty()) {
    print_line("warning", "the first steps fail: " + forecast.failure);
    return;
  }
  const std::string on = ranks == 1 ? "one rank" : fmt::format("{} ranks", ranks);
  const std::string tried = forecast.coarser == 1
                                ? "its first steps"
                                : fmt::format("steps on cells {} times as wide", forecast.coarser);
  print_line("forecast", fmt::format("about {:.0f} steps in {} on {}, from {}", forecast.steps,
                                     duration(forecast.seconds), on, tried));
  print_line("memory", fmt::format("about {} on {}", size(forecast.memory), on));
  print_line("disk",
             fmt::format("about {}: frames {}, tables {}, checkpoints {}; a report of up "
                         "to 20 MB",
                         size(forecast.frames + forecast.tables + forecast.checkpoints),
                         size(forecast.frames), size(forecast.tables), size(forecast.checkpoints)));
}

/// What the launching process has printed already its ranks do not.
constexpr const char* described_mark = "WASHTUB_DESCRIBED";

void print_case(const Case& whole, const std::vector<std::string>& more) {
  print_line("case", fmt::format("{} ({})", whole.title.empty() ? "untitled" : whole.title,
                                 whole.dimension == 3 ? "3-D" : "2-D"));
  for (const Fact& fact : describe(whole)) print_line(fact.name, fact.value);
  print_groups(whole);
  for (const auto* notes : {&whole.notes, &more})
    for (const std::string& note : *notes) print_line("note", note);
  for (const std::string& doubt : doubts(whole)) print_line("warning", doubt);
}

/// The part of a rank.
int begin_run(const CheckArguments& arguments) {
  const Mpi mpi;
  const Parallel parallel;
  const Case whole = read_case(arguments.input.path, arguments.input.settings);
  if (parallel.root() && !std::getenv(described_mark)) {
    print_case(whole, check_build(whole));
  }
  const Forecast forecast = foresee(whole, parallel);
  if (parallel.root()) print_forecast(forecast, parallel.size());
  return 0;
}

}  // namespace

int command_check(const CheckArguments& arguments) {
  if (inside_mpi()) return begin_run(arguments);
  const Case whole = read_case(arguments.input.path, arguments.input.settings);
  const std::vector<std::string> notes = check_build(whole);
  const RankChoice choice =
      arguments.forecast ? choose_ranks(arguments.ranks, whole) : RankChoice();
  print_case(whole, notes);
  if (!arguments.forecast) return 0;
  if (!choice.note.empty()) print_line("note", choice.note);
  std::fflush(stdout);
  setenv(described_mark, "", 1);
  return choice.ranks == 1 ? begin_run(arguments) : launch_ranks(choice.ranks, arguments.all);
}

}  // namespace washtub
