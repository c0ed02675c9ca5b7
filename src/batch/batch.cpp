#include "batch/batch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "batch/jobs.hpp"
#include "io/file.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* begun = "begun.json";  ///< in the folder of a run that has begun
constexpr const char* console = "console.txt";
constexpr const char* wall_key = "wall time [s]";

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// What a file in the folder of a run says, where that is of the run as it would be made now.
Json note(const BatchRun& run, const char* file) {
  const Json found = Json::parse(content(run.result->directory + '/' + file), nullptr, false);
  if (!found.is_object()) return nullptr;
  for (const auto& [key, value] : run.fingerprint.items())
    if (!found.contains(key) || found[key] != value) return nullptr;
  return found;
}

/// Takes over the run if its folder holds it as it would be made now.
bool keep(const BatchRun& run, const BatchPlan& plan) {
  RunResult& result = *run.result;
  const Json found = note(run, finished_mark);
  if (plan.force || !found.contains(wall_key)) return false;
  result.state = RunState::kept;
  result.wall = found[wall_key].is_number() ? found[wall_key].get<double>() : std::nan("");
  return true;
}

/// The line in which the program says what went wrong, or else the last one.
std::string error_line(const std::string& file_name) {
  std::ifstream file(file_name);
  std::string found, last;
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("washtub: ")) found = line.substr(9);
    if (!line.empty()) last = line;
  }
  return found.empty() ? last : found;
}

void finish(const BatchRun& run, const BatchPlan& plan, int code, double wall) {
  RunResult& result = *run.result;
  result.wall = wall;
  result.state = code == 0                             ? RunState::done
                 : code == exit_stopped || plan.stop() ? RunState::stopped
                                                       : RunState::failed;
  if (result.state == RunState::failed) {
    result.error = code > 128 ? fmt::format("ended by signal {}", code - 128)
                              : error_line(result.directory + '/' + console);
    if (result.error.empty()) result.error = fmt::format("ended with code {}", code);
  }
  if (code != 0) return;
  Json print = run.fingerprint;
  print[wall_key] = wall;
  replace_file(result.directory + '/' + finished_mark, print.dump(2) + '\n');
}

void make_folder(const std::string& directory) {
  std::error_code error;
  fs::create_directories(directory, error);
  if (error) throw RunError(fmt::format("{}: cannot be made: {}", directory, error.message()));
  fs::remove(fs::path(directory) / finished_mark, error);
}

/// The command of a run, whose folder notes that it begins.
Job begin(const BatchRun& run, const BatchPlan& plan) {
  const std::string& directory = run.result->directory;
  make_folder(directory);
  const bool goes_on = !plan.force && !run.trace.empty() && !note(run, begun).is_null() &&
                       fs::exists(fs::path(directory) / run.trace);
  if (!goes_on) replace_file(directory + '/' + begun, run.fingerprint.dump(2) + '\n');
  Job job{{plan.program}, directory + '/' + console};
  const auto& words = goes_on ? run.again : run.words;
  job.words.insert(job.words.end(), words.begin(), words.end());
  return job;
}

/// Those that have to be made, the longest first.
std::vector<const BatchRun*> missing(const std::vector<BatchRun>& runs, const BatchPlan& plan) {
  std::vector<const BatchRun*> found;
  for (const BatchRun& run : runs) {
    if (keep(run, plan))
      plan.progress(fmt::format("{}: kept, made earlier in {:.1f} s", run.name, run.result->wall));
    else if (run.wanted)
      found.push_back(&run);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto* a, const auto* b) { return a->cost > b->cost; });
  return found;
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

/// Fowler, Noll and Vo's 64-bit hash (FNV-1a).
std::string hash_of_file(const std::string& path) {
  const std::string text = content(path);
  if (text.empty()) return "";
  std::uint64_t h = 14695981039346656037ULL;
  for (const char c : text) h = (h ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  return fmt::format("{:016x}", h);
}

void make_batch(const std::vector<BatchRun>& runs, const BatchPlan& plan) {
  const auto made = missing(runs, plan);
  std::vector<Job> jobs;
  for (const BatchRun* run : made) jobs.push_back(begin(*run, plan));
  const auto started = [&](std::size_t i) {
    plan.progress(fmt::format("{}: started, {} of {}", made[i]->name, i + 1, made.size()));
  };
  const auto ended = [&](std::size_t i, int code, double wall) {
    const BatchRun& run = *made[i];
    finish(run, plan, code, wall);
    plan.progress(fmt::format("{}: {} after {:.1f} s{}{}", run.name, name(run.result->state), wall,
                              run.result->error.empty() ? "" : ": ", run.result->error));
  };
  run_jobs(jobs, plan.at_once, {started, ended, plan.stop});
}

}  // namespace washtub
