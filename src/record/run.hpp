#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"

namespace washtub {

struct RunOptions {
  std::string directory;               ///< of the results; exists when the simulation starts
  bool force = false;                  ///< results of an earlier run may be overwritten
  std::vector<std::string> arguments;  ///< the command line, for the log
  std::string program;                 ///< name and version, for checkpoints
  std::string resumed;                 ///< checkpoint of this run to go on from; "" = none
  std::vector<std::string> changes;    ///< of the case since that checkpoint, for the log
  std::string developed;  ///< checkpoint of another run whose water and cloth this one starts with
};

/// Simulates on all ranks of MPI_COMM_WORLD and writes the results.
/// Asks stop_requested() between steps and then ends early with everything written, a checkpoint
/// too. A step that fails is tried again with remedies from the row before it, before the run ends.
/// Returns the exit code: 0, or 130 when it was asked to stop. Every rank returns the same.
/// @throws RunError on any one rank, or on all
int run_case(const Case& whole, const RunOptions& options);

}  // namespace washtub
