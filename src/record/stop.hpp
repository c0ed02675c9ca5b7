#pragma once

namespace washtub {

/// Tells a signal that ends a run at once from those that come with the first one: a closed
/// terminal and a scheduler send theirs to every process, and some of them twice.
class SignalCounter {
 public:
  /// Whether it is a Ctrl-C or SIGTERM more than a second after the first signal. May be called
  /// from a signal handler.
  bool is_second(int signal);

 private:
  double first_ = 0;  ///< when the first one came [s]
};

/// From now on SIGINT, SIGTERM, SIGHUP (a closed terminal) and SIGUSR1 (which mpirun passes on) ask
/// the run to stop; a second SIGINT or SIGTERM ends it at once. Nobody reading what is printed does
/// not.
void install_stop_handlers();

/// Calls the handler at those signals; not at SIGHUP where nohup has it ignored.
void at_stop_signals(void (*handler)(int));

/// Whether this process was asked to stop; ranks must agree before acting on it.
bool stop_requested();

}  // namespace washtub
