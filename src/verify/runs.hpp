#pragma once
#include <string>
#include <vector>

#include "batch/batch.hpp"
#include "verify/expected.hpp"

namespace washtub {

/// A verification case with its runs, one result per run of `expected`.
struct CaseRuns {
  Expected expected;
  std::vector<RunResult> runs;
};

/// What goes for all runs.
struct RunPlan {
  std::string identity;   ///< of the program: what it computes is the same where this is
  std::string directory;  ///< of the results
  VerifyLevel level = VerifyLevel::quick;
  BatchPlan batch;
};

/// The command that makes a run, after the name of the program.
std::vector<std::string> run_words(const Expected& expected, const RunSpec& run,
                                   const std::string& directory);

/// Makes the runs of the plan's level that are not there yet, as make_batch() does. What a run
/// writes is in <directory>/<case>/<run>.
void make_runs(std::vector<CaseRuns>& cases, const RunPlan& plan);

}  // namespace washtub
