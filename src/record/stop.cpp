#include "record/stop.hpp"

#include <csignal>
#include <initializer_list>

namespace washtub {
namespace {

volatile std::sig_atomic_t stop = 0;

void on_signal(int) { stop = 1; }

}  // namespace

void install_stop_handlers() {
  for (const int signal : {SIGINT, SIGTERM, SIGUSR1}) std::signal(signal, on_signal);
}

bool stop_requested() { return stop != 0; }

}  // namespace washtub
