#pragma once

namespace washtub {

/// What every command returns to the shell.
enum ExitCode : int {
  exit_done = 0,
  exit_failed = 1,
  exit_wrong_input = 2,
  exit_no_report = 3,
  exit_stopped = 130,
};

constexpr const char* exit_codes =
    "Exit codes:\n"
    "  0    done\n"
    "  1    the simulation or the command failed; verify: a value misses or a run failed\n"
    "  2    wrong input or command line; nothing was simulated\n"
    "  3    run: complete, but its report.html could not be made; washtub report DIR makes it\n"
    "  130  ended in order when asked to (Ctrl-C, SIGTERM, SIGHUP, SIGUSR1)\n"
    "  128 + a signal's number: ended at once by a second signal, or killed";

}  // namespace washtub
