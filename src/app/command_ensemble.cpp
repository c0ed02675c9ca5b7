#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "app/commands.hpp"
#include "app/directory.hpp"
#include "app/launch.hpp"
#include "app/ranks.hpp"
#include "app/size.hpp"
#include "app/start_point.hpp"
#include "app/text_table.hpp"
#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "batch/batch.hpp"
#include "ensemble/ensemble.hpp"
#include "ensemble/members.hpp"
#include "io/file.hpp"
#include "io/lock.hpp"
#include "record/stop.hpp"
#include "report/page.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

constexpr const char* page = "/ensemble.html";
constexpr const char* numbers = "/pooled.json";

/// @throws InputError where other things than an ensemble are in the way
void prepare_folder(const std::string& directory, bool force) {
  make_results_folder(directory);
  std::error_code none;
  if (!force && !is_ensemble(directory) && !fs::is_empty(directory, none))
    throw InputError(fmt::format(
        "{}: holds files that are of no ensemble; name another directory with -o", directory));
}

/// Whether a member has begun and left what it takes to go on. One that only seems to be done is
/// not kept.
/// @throws InputError where it is of another case, or cannot go on to what the case says now
bool has_begun(const std::string& directory, const Case& member) {
  const fs::path folder = directory;
  if (!fs::exists(folder / "log.txt")) return false;
  if (const auto differing = differing_case(directory, member); !differing.empty())
    throw InputError(
        fmt::format("{}: is of another case: {}; name another directory with -o, or make all "
                    "members anew with --force",
                    directory, fmt::join(differing, "; ")));
  check_going_on(directory, member);
  const bool sound = fs::exists(folder / "history.csv") && fs::exists(folder / "case.toml");
  if (!sound || !is_complete(directory)) fs::remove(folder / finished_mark);
  return sound;
}

/// The members' runs, one for each result. Those that have begun go on.
std::vector<BatchRun> member_runs(const EnsembleArguments& arguments,
                                  const std::vector<std::uint64_t>& seeds,
                                  const std::string& directory, std::vector<RunResult>& results) {
  const CaseArguments& input = arguments.input;
  const Case whole = read_case(input.path, input.settings);
  choose_ranks(arguments.ranks, whole);
  results.resize(seeds.size());
  std::vector<BatchRun> runs;
  for (std::size_t i = 0; i < seeds.size(); ++i) {
    const std::string name = member_name(seeds[i]);
    results[i].directory = (fs::path(directory) / name).string();
    std::vector<std::string> settings = input.settings;
    for (auto& setting : member_settings(whole, seeds[i])) settings.push_back(std::move(setting));
    const Case member = read_case(input.path, settings);
    const bool begun = !arguments.force && has_begun(results[i].directory, member);
    std::vector<std::string> words = {
        "run",        input.path, "-o", results[i].directory, "-n", std::to_string(arguments.ranks),
        "--no-report"};
    for (const std::string& setting : settings) words.insert(words.end(), {"--set", setting});
    words.emplace_back(begun ? "--resume" : "--force");
    runs.push_back({name, words, words, "", {{"case", member.resolved}}, 0, true, &results[i]});
  }
  return runs;
}

std::string with_width(double value, double width) {
  if (!std::isfinite(width)) return as_exact(value, {});
  return fmt::format("{} +- {}", as_exact(value, width), as_exact(width, width));
}

std::string count_text(double count) {
  if (!std::isfinite(count)) return "-";
  return count >= 1e6 ? "> 1e6" : fmt::format("{:.0f}", count);
}

std::vector<TextRow> text_table(const Ensemble& ensemble) {
  std::vector<TextRow> table = {
      {"quantity", "mean", "+- by cycles", "spread", "seeds for 5 %", "cycles for 5 %"}};
  for (const PooledQuantity& q : ensemble.quantities) {
    const std::string spread =
        std::isfinite(q.pool.ratio)
            ? fmt::format("{:.2g}{}", std::sqrt(q.pool.ratio), q.pool.not_covered() ? " *" : "")
            : "-";
    table.push_back({fmt::format("{} [{}]", q.about.name, q.about.unit),
                     with_width(q.pool.mean, q.pool.half_width),
                     std::isfinite(q.pool.within) ? as_exact(q.pool.within, q.pool.within) : "-",
                     spread, count_text(q.seeds_wanted), count_text(q.cycles_wanted)});
  }
  return table;
}

void print_pooled(const Ensemble& ensemble) {
  fmt::print("seeds {}\n", fmt::join(ensemble.seeds, ", "));
  print(text_table(ensemble));
  fmt::print(
      "spread: of the members' means, over what their cycles let expect; * more than chance, at "
      "95 %\n\n{}\n",
      fmt::join(sentences(ensemble), "\n"));
}

/// Writes numbers and page, and prints what they say; false where the page cannot be made.
bool report(const Ensemble& ensemble, std::size_t limit) {
  replace_file(ensemble.directory + numbers, pooled_json(ensemble).dump(2) + '\n');
  print_pooled(ensemble);
  try {
    write_page(ensemble.directory + page, {program_name, ensemble.runs, nullptr, to_json(ensemble)},
               limit);
  } catch (const InputError& error) {
    std::fflush(stdout);
    fmt::print(stderr, "washtub: {}\n", error.what());
    return false;
  }
  fmt::print("\n{}{}\n", ensemble.directory, page);
  return true;
}

}  // namespace

int command_ensemble(const EnsembleArguments& arguments) {
  const std::size_t limit = parse_size(arguments.size);
  const auto seeds = parse_seeds(arguments.seeds);
  const std::string directory = arguments.directory.empty()
                                    ? default_directory(arguments.input.path) + "-ensemble"
                                    : arguments.directory;
  std::vector<RunResult> results;
  const std::vector<BatchRun> runs = member_runs(arguments, seeds, directory, results);
  prepare_folder(directory, arguments.force);
  const DirectoryLock lock(directory);
  for (const char* old : {page, numbers}) fs::remove(directory + old);
  write_members(directory, seeds);
  install_stop_handlers();
  const int cores = std::max(1, physical_cores() / arguments.ranks);
  make_batch(runs, {own_program(), arguments.jobs.value_or(cores), arguments.force, stop_requested,
                    [](const std::string& line) { fmt::print(stderr, "{}\n", line); }});
  const auto finished = std::count_if(results.begin(), results.end(),
                                      [](const RunResult& r) { return r.finished(); });
  const bool shown = finished == 0 || report(read_ensemble(directory), limit);
  std::fflush(stdout);
  if (stop_requested()) {
    fmt::print(stderr, "washtub: stopped; the same command goes on with what is unfinished\n");
    return exit_stopped;
  }
  if (finished < static_cast<long>(seeds.size())) return exit_failed;
  return shown ? exit_done : exit_no_report;
}

}  // namespace washtub
