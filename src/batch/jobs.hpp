#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace washtub {

/// A program to be run with both output streams in a file.
struct Job {
  std::vector<std::string> words;  ///< program and arguments
  std::string console;             ///< the file
};

/// What the caller hears of its jobs.
struct JobEvents {
  std::function<void(std::size_t job)> started;
  /// `code`: exit code, or 128 + number of the signal that ended it. `wall` in seconds.
  std::function<void(std::size_t job, int code, double wall)> ended;
  /// Asked many times a second: true ends the jobs that run and starts no more.
  std::function<bool()> stop;
};

/// Runs the jobs in order, `at_once` together, and returns when none is left. A job that is to stop
/// gets SIGTERM, and SIGKILL where it has not ended 20 s later. Jobs are out of reach of the
/// terminal's Ctrl-C and end with this process.
/// @throws RunError where a process or its console file cannot be made; other jobs are ended first
void run_jobs(const std::vector<Job>& jobs, int at_once, const JobEvents& events);

}  // namespace washtub
