#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"

namespace washtub {

struct RunOptions {
  std::string directory;               ///< of the results; exists when the simulation starts
  bool force = false;                  ///< results of an earlier run may be overwritten
  std::vector<std::string> arguments;  ///< the command line, for the log
};

/// Simulates on all ranks of MPI_COMM_WORLD and writes the results.
/// Asks stop_requested() between steps and then ends early with everything written.
/// Returns the exit code: 0, or 130 when it was asked to stop. Every rank returns the same.
/// @throws RunError on any one rank, or on all
int run_case(const Case& whole, const RunOptions& options);

}  // namespace washtub
