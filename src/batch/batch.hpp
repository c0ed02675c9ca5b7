#pragma once
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace washtub {

/// File in the folder of a run that is whole. Whoever writes there anew removes it.
inline constexpr const char* finished_mark = "finished.json";

enum class RunState {
  done,
  kept,  ///< finished earlier, with the same fingerprint
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

/// A run of this program in a folder of its own, result->directory.
struct BatchRun {
  std::string name;                    ///< in what is said of it
  std::vector<std::string> words;      ///< the command, after the name of the program
  std::vector<std::string> again;      ///< the same to go on with what was interrupted
  std::string trace;                   ///< file that the command leaves once it has begun; "": none
  nlohmann::ordered_json fingerprint;  ///< object of all that decides what it computes
  double cost = 0;                     ///< about how long it takes [s]; 0: not known
  bool wanted = true;                  ///< else it is only looked for
  RunResult* result = nullptr;
};

/// What goes for all runs of a batch.
struct BatchPlan {
  std::string program;  ///< path of the executable
  int at_once = 1;
  bool force = false;  ///< finished runs are made again
  std::function<bool()> stop;
  std::function<void(const std::string& line)> progress;
};

/// A number that stands for the content of a file, "" for one that cannot be read.
std::string hash_of_file(const std::string& path);

/// Makes the runs that are wanted and not there yet, the longest first. A run that fails does not
/// keep others from being made. What it prints is in console.txt of its folder.
/// @throws RunError where a folder cannot be written or no process be started
void make_batch(const std::vector<BatchRun>& runs, const BatchPlan& plan);

}  // namespace washtub
