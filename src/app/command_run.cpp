#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/commands.hpp"
#include "app/launch.hpp"
#include "app/mpi.hpp"
#include "app/ranks.hpp"
#include "app/report.hpp"
#include "app/start_point.hpp"
#include "base/error.hpp"
#include "base/exit_code.hpp"
#include "io/agree.hpp"
#include "io/hdf5_handle.hpp"
#include "record/run.hpp"
#include "record/stop.hpp"
#include "washer/build.hpp"
#include "washer/resolution.hpp"

namespace washtub {
namespace {

/// What the launching process found out tells its ranks in the environment.
constexpr const char* resumed_mark = "WASHTUB_RESUMED";
constexpr const char* developed_mark = "WASHTUB_DEVELOPED";

int rank() {
  int value = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &value);
  return value;
}

void print_error(const char* message) {
  std::fputs(fmt::format("washtub: {}\n", message).c_str(), stderr);
}

/// Whether all ranks come here within two seconds, so that none is left waiting for another.
bool all_failed() {
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibarrier(MPI_COMM_WORLD, &request);
  int done = 0;
  for (int wait = 0; wait < 200 && !done; ++wait) {
    MPI_Test(&request, &done, MPI_STATUS_IGNORE);
    if (!done) usleep(10000);
  }
  return done != 0;
}

/// The exit code of this rank, unless the files that it could not write keep it from ending well.
int leave(int code) {
  if (!hdf5_lost) return code;
  std::fflush(nullptr);
  std::_Exit(code);
}

/// Ends quietly where every rank failed alike, else ends the others too. `last_words` are those of
/// the first rank.
template <class LastWords>
int fail(const char* message, int code, const LastWords& last_words) {
  const bool together = all_failed();
  if (!together || rank() == 0) print_error(message);
  if (rank() == 0) last_words();
  if (!together) MPI_Abort(MPI_COMM_WORLD, code);
  return leave(code);
}

bool is_prepared() { return std::getenv(resumed_mark) != nullptr; }

/// Under a launcher other than ours rank 0 still has to see to the start, and holds the directory.
DirectoryLock prepare_once(const RunArguments& arguments, const Case& whole, RunOptions& options) {
  DirectoryLock lock;
  if (is_prepared()) {
    options.resumed = std::getenv(resumed_mark);
    options.developed = std::getenv(developed_mark);
    return lock;
  }
  const Parallel parallel;
  std::string refusal;
  if (parallel.root()) {
    try {
      lock = prepare_start(arguments, whole, options);
    } catch (const InputError& error) {
      refusal = error.what();
    }
  }
  refusal = from_root(parallel, refusal);
  if (!refusal.empty()) throw InputError(refusal);
  options.resumed = from_root(parallel, options.resumed);
  options.developed = from_root(parallel, options.developed);
  return lock;
}

/// The exit code of a run whose page could not be made.
int without_report(int code) { return code == exit_done ? exit_no_report : code; }

void print_notes(const Case& whole) {
  for (const std::string& note : whole.notes) fmt::print(stderr, "note: {}\n", note);
  for (const std::string& doubt : doubts(whole)) fmt::print(stderr, "warning: {}\n", doubt);
}

/// One rank of the simulation. Ranks that command_run has launched leave the report to it, since
/// any of them may be the one that fails.
int simulate(const RunArguments& arguments, RunOptions options) {
  const bool launched = inside_mpi() && is_prepared();
  const Mpi mpi;
  install_stop_handlers();
  const auto report = [&] {
    return !arguments.report || launched || report_run(options.directory);
  };
  DirectoryLock lock;
  try {
    const Case whole = read_case(arguments.input.path, arguments.input.settings);
    lock = prepare_once(arguments, whole, options);
    if (rank() == 0 && !launched) print_notes(whole);
    const int code = run_case(whole, options);
    return leave(rank() > 0 || report() ? code : without_report(code));
  } catch (const InputError& error) {
    return fail(error.what(), exit_wrong_input, [] {});
  } catch (const std::exception& error) {
    return fail(error.what(), exit_failed, report);
  }
}

}  // namespace

int command_run(RunArguments arguments) {
  settle_directory(arguments);
  RunOptions options{arguments.directory, arguments.force, arguments.all, program_name, {}, {}, {}};
  if (inside_mpi()) return simulate(arguments, options);
  const Case whole = read_case(arguments.input.path, arguments.input.settings);
  for (const std::string& note : check_build(whole)) fmt::print(stderr, "note: {}\n", note);
  const RankChoice choice = choose_ranks(arguments.ranks, whole);
  const DirectoryLock lock = prepare_start(arguments, whole, options);
  if (!choice.note.empty()) fmt::print(stderr, "note: {}\n", choice.note);
  setenv(resumed_mark, options.resumed.c_str(), 1);
  setenv(developed_mark, options.developed.c_str(), 1);
  if (choice.ranks == 1) return simulate(arguments, options);
  print_notes(whole);
  const int code = launch_ranks(choice.ranks, arguments.all);
  if (!arguments.report || code == exit_wrong_input || report_run(options.directory)) return code;
  return without_report(code);
}

}  // namespace washtub
