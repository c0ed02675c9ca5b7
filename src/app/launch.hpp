#pragma once
#include <string>
#include <vector>

namespace washtub {

/// Whether mpirun, srun or another launcher started this process as one of several ranks.
bool inside_mpi();

/// Path of this program.
std::string own_program();

/// Cores of this machine that this process may use, hardware threads of a core counted once.
int physical_cores();

/// Runs this program again with the same arguments under mpirun and returns its exit code.
/// SIGINT, SIGTERM and SIGHUP are passed on so that the ranks finish their step; a second SIGINT or
/// SIGTERM ends them.
/// @throws RunError where mpirun cannot be started
int launch_ranks(int ranks, const std::vector<std::string>& arguments);

}  // namespace washtub
