#include "record/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace washtub {
namespace {

double now() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

std::string clock(double seconds) {
  const int s = static_cast<int>(seconds + 0.5);
  return s < 3600 ? fmt::format("{}:{:02}", s / 60, s % 60)
                  : fmt::format("{}:{:02}:{:02}", s / 3600, s / 60 % 60, s % 60);
}

/// Whether or not anybody takes it: a run goes on without its terminal.
void tell(const std::string& text) { std::fputs(text.c_str(), stderr); }

}  // namespace

Progress::Progress(double end, bool shown)
    : end_(end), start_(now()), shown_(shown), terminal_(isatty(STDERR_FILENO) == 1) {}

double Progress::elapsed() const { return now() - start_; }

void Progress::state(Archive& archive) {
  double spent = elapsed();
  archive.value("elapsed", spent);
  start_ = now() - spent;
}

bool Progress::show(double time, const std::string& state) {
  const double spent = elapsed();
  if (!shown_ || spent < next_) return false;
  next_ = spent + (terminal_ ? 0.5 : 10);
  const double share = time / end_;
  const std::string left =
      share > 0 && spent > 3 ? fmt::format("  {} to go", clock(spent / share * (1 - share))) : "";
  tell(fmt::format("{}t {:.4g} of {:.4g} s ({:.0f} %)  {}{}{}", terminal_ ? "\r" : "", time, end_,
                   100 * share, state, left, terminal_ ? "\x1b[K" : "\n"));
  std::fflush(stderr);
  return true;
}

void Progress::finish() const {
  if (shown_ && terminal_) tell("\n");
}

}  // namespace washtub
