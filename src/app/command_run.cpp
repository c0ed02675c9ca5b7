#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "app/commands.hpp"
#include "app/launch.hpp"
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

/// Initialises MPI for as long as it lives.
struct Mpi {
  Mpi() { MPI_Init(nullptr, nullptr); }
  ~Mpi() { MPI_Finalize(); }
  Mpi(const Mpi&) = delete;
  Mpi& operator=(const Mpi&) = delete;
};

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

/// Whether the grid can be cut for so many ranks.
template <int D>
bool can_cut(const Case& whole, int ranks) {
  const auto mesh = build_mesh<D>(whole);
  try {
    choose_ranks<D>(mesh.cells, granularity(mesh), ranks);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

bool can_cut(const Case& whole, int ranks) {
  return whole.dimension == 3 ? can_cut<3>(whole, ranks) : can_cut<2>(whole, ranks);
}

/// The number asked for, or the physical cores as far as the grid can be cut for them.
int choose_ranks(const RunArguments& arguments, const Case& whole) {
  int ranks = arguments.ranks.value_or(physical_cores());
  if (ranks < 1) throw InputError(fmt::format("-n {}: allowed: 1 or more ranks", ranks));
  const auto fewer = [&](int n) {
    while (n > 1 && !can_cut(whole, n)) --n;
    return n;
  };
  if (!arguments.ranks) return fewer(ranks);
  if (!can_cut(whole, ranks))
    throw InputError(fmt::format("-n {}: this grid cannot be cut for so many ranks; try -n {}",
                                 ranks, fewer(ranks)));
  return ranks;
}

}  // namespace

int command_run(RunArguments arguments) {
  settle_directory(arguments);
  RunOptions options{arguments.directory, arguments.force, arguments.all, program_name, {}, {}, {}};
  if (inside_mpi()) return simulate(arguments, options);
  const Case whole = read_case(arguments.input.path, arguments.input.settings);
  check_build(whole);
  const int ranks = choose_ranks(arguments, whole);
  const DirectoryLock lock = prepare_start(arguments, whole, options);
  setenv(resumed_mark, options.resumed.c_str(), 1);
  setenv(developed_mark, options.developed.c_str(), 1);
  if (ranks == 1) return simulate(arguments, options);
  print_notes(whole);
  const int code = launch_ranks(ranks, arguments.all);
  if (!arguments.report || code == exit_wrong_input || report_run(options.directory)) return code;
  return without_report(code);
}

}  // namespace washtub
