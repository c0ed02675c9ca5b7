#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "app/commands.hpp"
#include "app/directory.hpp"
#include "app/launch.hpp"
#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "base/nearest.hpp"
#include "io/file.hpp"
#include "record/stop.hpp"
#include "verify/page.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

/// Where the cases are: what the user says, else the installed ones, else those of the source tree.
std::string cases_directory(const VerifyArguments& arguments) {
  if (!arguments.cases.empty()) return arguments.cases;
  const fs::path installed =
      fs::path(own_program()).parent_path().parent_path() / "share" / "washtub" / "verification";
  return fs::is_directory(installed) ? installed.string() : WASHTUB_SOURCE "/verification";
}

/// The cases asked for, in the order of the folder.
/// @throws InputError naming one that is not there
std::vector<std::string> chosen(const std::vector<std::string>& known,
                                const std::vector<std::string>& asked) {
  for (const std::string& name : asked) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const std::string nearest = nearest_name(name, known);
    throw InputError(fmt::format("no verification case {}, {}", name,
                                 nearest.empty()
                                     ? fmt::format("there are {}", fmt::join(known, ", "))
                                     : "nearest: " + nearest));
  }
  if (asked.empty()) return known;
  std::vector<std::string> names = known;
  std::erase_if(names, [&](const std::string& name) {
    return std::find(asked.begin(), asked.end(), name) == asked.end();
  });
  return names;
}

std::vector<CaseRuns> read_cases(const VerifyArguments& arguments) {
  const std::string directory = cases_directory(arguments);
  std::vector<CaseRuns> cases;
  for (const std::string& name : chosen(case_names(directory), arguments.names))
    cases.push_back({read_expected((fs::path(directory) / name).string()), {}});
  return cases;
}

int list_cases(const std::vector<CaseRuns>& cases) {
  for (const CaseRuns& c : cases) {
    fmt::print("{}: {}\n", c.expected.name, c.expected.title);
    for (const RunSpec& run : c.expected.runs)
      fmt::print("  {}, {}{}\n", run.name, run.level == VerifyLevel::quick ? "quick" : "full",
                 run.cost > 0 ? fmt::format(", about {:.0f} s", run.cost) : "");
  }
  return 0;
}

RunPlan make_plan(const VerifyArguments& arguments) {
  RunPlan plan;
  plan.identity = fmt::format("{} {}", WASHTUB_VERSION, hash_of_file(own_program()));
  plan.directory = arguments.directory;
  plan.level = arguments.level;
  plan.batch = {own_program(), arguments.jobs.value_or(physical_cores()), arguments.force,
                stop_requested, [](const std::string& line) { fmt::print(stderr, "{}\n", line); }};
  return plan;
}

Report make_report(std::vector<CaseRuns>&& cases, const RunPlan& plan) {
  Report report;
  report.program = program_name;
  report.level = plan.level;
  report.interrupted = plan.batch.stop();
  for (CaseRuns& c : cases) {
    CaseReport entry;
    entry.judgements = judge(c);
    entry.figures = draw_figures(c, plan.directory);
    entry.made = std::move(c);
    report.cases.push_back(std::move(entry));
  }
  return report;
}

int exit_code(const Report& report, bool allow_known) {
  const Count n = count(report);
  if (report.interrupted) return exit_stopped;
  if (n.wrong_input > 0) return exit_wrong_input;
  const int misses = n.miss + (allow_known ? 0 : n.known_miss);
  return misses > 0 || n.failed_runs > 0 ? exit_failed : exit_done;
}

}  // namespace

int command_verify(const VerifyArguments& arguments) {
  std::vector<CaseRuns> cases = read_cases(arguments);
  if (arguments.list) return list_cases(cases);
  make_results_folder(arguments.directory);
  install_stop_handlers();
  const RunPlan plan = make_plan(arguments);
  make_runs(cases, plan);
  const Report report = make_report(std::move(cases), plan);
  replace_file(arguments.directory + "/verification.json", report_json(report).dump(2) + '\n');
  replace_file(arguments.directory + "/verification.html", report_page(report));
  fmt::print("{}\n{}\n{}/verification.html\n", terminal_table(report), summary_line(report),
             arguments.directory);
  return exit_code(report, arguments.allow_known);
}

}  // namespace washtub
