#include "record/stop.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <ctime>
#include <initializer_list>

namespace washtub {
namespace {

volatile std::sig_atomic_t stop = 0;
std::array<bool, 3> on_terminal{};  ///< whether the standard streams are one

/// What a closed terminal would refuse to take goes nowhere.
void leave_closed_terminal() {
  const int nowhere = open("/dev/null", O_RDWR);
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (on_terminal[static_cast<std::size_t>(stream)] && isatty(stream) == 0) dup2(nowhere, stream);
  close(nowhere);
}

void on_signal(int signal) {
  static SignalCounter counter;
  if (signal == SIGHUP) leave_closed_terminal();
  stop = 1;
  if (!counter.is_second(signal)) return;
  std::signal(signal, SIG_DFL);
  raise(signal);
}

/// Monotonic [s]; to be called from a signal handler.
double now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

bool SignalCounter::is_second(int signal) {
  const bool later = first_ > 0 && now() > first_ + 1;
  if (first_ == 0) first_ = now();
  return later && (signal == SIGINT || signal == SIGTERM);
}

void install_stop_handlers() {
  for (int stream = 0; stream < 3; ++stream)
    on_terminal[static_cast<std::size_t>(stream)] = isatty(stream) == 1;
  at_stop_signals(on_signal);
  std::signal(SIGPIPE, SIG_IGN);
}

void at_stop_signals(void (*handler)(int)) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) {
    const auto before = std::signal(signal, handler);
    if (signal == SIGHUP && before == SIG_IGN) std::signal(signal, SIG_IGN);
  }
}

bool stop_requested() { return stop != 0; }

}  // namespace washtub
