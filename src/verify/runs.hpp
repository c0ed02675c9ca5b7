#pragma once
#include <functional>
#include <string>
#include <vector>

#include "verify/expected.hpp"

namespace washtub {

enum class RunState {
  done,
  kept,  ///< finished earlier, by the same program from the same case and settings
  failed,
  stopped,
  not_run
};

std::string name(RunState state);

/// What has become of a run.
struct RunResult {
  std::string directory;  ///< of its results
  RunState state = RunState::not_run;
  double wall = std::nan("");  ///< what it took when it was run [s]
  std::string error;           ///< the line in which a failed run says why

  bool finished() const { return state == RunState::done || state == RunState::kept; }
};

/// A verification case with its runs, one result per run of `expected`.
struct CaseRuns {
  Expected expected;
  std::vector<RunResult> runs;
};

/// What goes for all runs.
struct RunPlan {
  std::string program;    ///< path of the executable
  std::string identity;   ///< of the program: what it computes is the same where this is
  std::string directory;  ///< of the results
  VerifyLevel level = VerifyLevel::quick;
  int at_once = 1;
  bool force = false;
  std::function<bool()> stop;
  std::function<void(const std::string& line)> progress;
};

/// Version and a number that stands for the content of the executable.
std::string program_identity(const std::string& program, const std::string& version);

/// The command that makes a run, after the name of the program.
std::vector<std::string> run_words(const Expected& expected, const RunSpec& run,
                                   const std::string& directory);

/// Makes the runs of the plan's level that are not there yet, the longest first. A run that fails
/// does not keep others from being made. What it writes is in <directory>/<case>/<run>.
/// @throws RunError where a folder cannot be written or no process be started
void make_runs(std::vector<CaseRuns>& cases, const RunPlan& plan);

}  // namespace washtub
