#include "verify/runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "io/file.hpp"
#include "verify/jobs.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* mark = "finished.json";  ///< in the folder of a run that is whole
constexpr const char* wall_key = "wall time [s]";

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// Fowler, Noll and Vo's 64-bit hash (FNV-1a).
std::string hash(const std::string& text) {
  std::uint64_t h = 14695981039346656037ULL;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", h);
}

std::string case_path(const Expected& expected, const RunSpec& run) {
  return (fs::path(expected.directory) / run.file).string();
}

/// All that decides what a run computes.
Json fingerprint(const CaseRuns& c, std::size_t i, const RunPlan& plan) {
  const RunSpec& run = c.expected.runs[i];
  auto words = run_words(c.expected, run, "");
  std::erase(words, case_path(c.expected, run));
  return {{"program", plan.identity},
          {"command", words},
          {"case file", hash(content(case_path(c.expected, run)))}};
}

/// Takes over the run if its folder holds it as it would be made now.
bool keep(CaseRuns& c, std::size_t i, const RunPlan& plan) {
  RunResult& result = c.runs[i];
  const Json found = Json::parse(content(result.directory + '/' + mark), nullptr, false);
  if (plan.force || !found.is_object() || !found.contains(wall_key)) return false;
  const Json expected = fingerprint(c, i, plan);
  for (const auto& [key, value] : expected.items())
    if (!found.contains(key) || found[key] != value) return false;
  result.state = RunState::kept;
  result.wall = found[wall_key].is_number() ? found[wall_key].get<double>() : std::nan("");
  return true;
}

/// The line in which the program says what went wrong, or else the last one.
std::string error_line(const std::string& console) {
  std::ifstream file(console);
  std::string found, last;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("washtub: ")) found = line.substr(9);
    if (!line.empty()) last = line;
  }
  return found.empty() ? last : found;
}

void finish(CaseRuns& c, std::size_t i, const RunPlan& plan, int code, double wall) {
  RunResult& result = c.runs[i];
  result.wall = wall;
  result.state = code == 0                             ? RunState::done
                 : code == exit_stopped || plan.stop() ? RunState::stopped
                                                       : RunState::failed;
  if (result.state == RunState::failed) {
    result.error = error_line(result.directory + "/console.txt");
    if (result.error.empty()) result.error = fmt::format("ended with code {}", code);
  }
  if (code != 0) return;
  Json print = fingerprint(c, i, plan);
  print[wall_key] = wall;
  replace_file(result.directory + '/' + mark, print.dump(2) + '\n');
}

struct Place {
  CaseRuns* of;
  std::size_t run;

  const RunSpec& spec() const { return of->expected.runs[run]; }
  std::string name() const { return of->expected.name + '/' + spec().name; }
};

void make_folder(const std::string& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw RunError(fmt::format("{}: cannot be made: {}", directory, error.message()));
  fs::remove(fs::path(directory) / mark, error);
}

/// Runs of the level that have to be made, the longest first.
std::vector<Place> missing(std::vector<CaseRuns>& cases, const RunPlan& plan) {
  std::vector<Place> places;
  for (CaseRuns& c : cases) {
    c.runs.resize(c.expected.runs.size());
    for (std::size_t i = 0; i < c.runs.size(); ++i) {
      const Place place{&c, i};
      c.runs[i].directory = plan.directory + '/' + place.name();
      if (keep(c, i, plan)) {
        plan.progress(
            fmt::format("{}: kept, made earlier in {:.1f} s", place.name(), c.runs[i].wall));
      } else if (place.spec().level <= plan.level) {
        places.push_back(place);
      }
    }
  }
  std::stable_sort(places.begin(), places.end(),
                   [](const Place& a, const Place& b) { return a.spec().cost > b.spec().cost; });
  return places;
}

}  // namespace

std::string name(RunState state) {
  switch (state) {
    case RunState::done:
      return "done";
    case RunState::kept:
      return "kept";
    case RunState::failed:
      return "failed";
    case RunState::stopped:
      return "stopped";
    case RunState::not_run:
      return "not run";
  }
  return "";
}

std::string program_identity(const std::string& program, const std::string& version) {
  return version + ' ' + hash(content(program));
}

namespace {

/// The most modes that a quantity or a figure asks of a run.
int modes_of(const Expected& expected, const std::string& run) {
  int most = 1;
  const auto ask = [&](const Measured& what, const std::vector<std::string>& runs) {
    if (std::find(runs.begin(), runs.end(), run) != runs.end()) most = std::max(most, what.mode);
  };
  for (const Quantity& q : expected.quantities) ask(q, q.used_runs());
  for (const Figure& figure : expected.figures)
    for (const Curve& curve : figure.curves) ask(curve, curve.runs);
  return most;
}

}  // namespace

std::vector<std::string> run_words(const Expected& expected, const RunSpec& run,
                                   const std::string& directory) {
  std::vector<std::string> words = {run.command, case_path(expected, run)};
  if (run.command == "modes") {
    words.insert(words.end(), {"--count", std::to_string(modes_of(expected, run.name)), "-o",
                               directory + "/modes.json"});
  } else {
    words.insert(words.end(), {"-o", directory, "-n", "1", "--force", "--no-report"});
  }
  for (const std::string& setting : run.settings) words.insert(words.end(), {"--set", setting});
  return words;
}

void make_runs(std::vector<CaseRuns>& cases, const RunPlan& plan) {
  const std::vector<Place> places = missing(cases, plan);
  std::vector<Job> jobs;
  for (const Place& place : places) {
    const std::string& directory = place.of->runs[place.run].directory;
    make_folder(directory);
    Job job{{plan.program}, directory + "/console.txt"};
    for (auto& word : run_words(place.of->expected, place.spec(), directory))
      job.words.push_back(std::move(word));
    jobs.push_back(std::move(job));
  }
  const auto started = [&](std::size_t i) {
    plan.progress(fmt::format("{}: started, {} of {}", places[i].name(), i + 1, places.size()));
  };
  const auto ended = [&](std::size_t i, int code, double wall) {
    const Place& place = places[i];
    finish(*place.of, place.run, plan, code, wall);
    const RunResult& result = place.of->runs[place.run];
    plan.progress(fmt::format("{}: {} after {:.1f} s{}{}", place.name(), name(result.state), wall,
                              result.error.empty() ? "" : ": ", result.error));
  };
  run_jobs(jobs, plan.at_once, {started, ended, plan.stop});
}

}  // namespace washtub
