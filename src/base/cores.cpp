#include "base/cores.hpp"

#include <fmt/format.h>
#include <sched.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

namespace washtub {
namespace {

constexpr int look = 200000;       // how long processors are looked at [us]
constexpr double own_core = 0.85;  // share of a core that a rank has at least where it is alone

/// Time that a processor has worked and has rested since the system started, in its ticks.
struct Ticks {
  double worked = 0, rested = 0;
};

/// Of the processors that this process may use; empty where /proc/stat is not as expected.
std::map<int, Ticks> read_ticks() {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  sched_getaffinity(0, sizeof allowed, &allowed);
  std::map<int, Ticks> ticks;
  std::ifstream file("/proc/stat");
  for (std::string line; std::getline(file, line) && line.starts_with("cpu");) {
    std::istringstream words(line.substr(3));
    int cpu = -1;
    double user = 0, nice = 0, system = 0, idle = 0, waiting = 0;
    if (line[3] == ' ' || !(words >> cpu >> user >> nice >> system >> idle >> waiting)) continue;
    if (cpu >= 0 && cpu < CPU_SETSIZE && CPU_ISSET(cpu, &allowed))
      ticks[cpu] = {user + nice + system, idle + waiting};
  }
  return ticks;
}

/// Processor time of this process [s].
double worked_now() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

}  // namespace

int free_ranks(int cores, double busy) {
  return std::clamp(static_cast<int>(std::lround(cores - busy)), 1, std::max(cores, 1));
}

double busy_cores() {
  const auto before = read_ticks();
  usleep(look);
  double busy = 0;
  for (const auto& [cpu, now] : read_ticks()) {
    const auto then = before.find(cpu);
    if (then == before.end()) continue;
    const double worked = now.worked - then->second.worked;
    const double rested = now.rested - then->second.rested;
    if (worked + rested > 0) busy += worked / (worked + rested);
  }
  return busy;
}

void CoreShare::begin() {
  since_ = std::chrono::steady_clock::now();
  worked_since_ = worked_now();
}

void CoreShare::end() {
  worked_ += worked_now() - worked_since_;
  passed_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - since_).count();
}

std::optional<std::string> crowded(double share, int ranks) {
  if (ranks == 1 || share >= own_core) return {};
  return fmt::format(
      "A rank gets {:.0f} % of a core only, because other programs run on it, and the {} ranks "
      "wait "
      "for each other; try {} (-n), or end the other programs.",
      100 * share, ranks, ranks == 2 ? "one rank" : "fewer ranks");
}

}  // namespace washtub
