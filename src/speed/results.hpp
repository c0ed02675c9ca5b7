#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace washtub {

/// How fast a kernel or a step was. 0 stands for what does not apply.
struct Speed {
  std::string name;    ///< "projection, 64^3"
  double seconds = 0;  ///< one call
  double cells = 0;    ///< of the grid that it went through
  double bytes = 0;    ///< that it has to move to and from memory at least

  double cell_rate() const { return cells / seconds; }  ///< [1/s]
  double byte_rate() const { return bytes / seconds; }  ///< [B/s]
};

/// What was measured in one go, on one machine.
struct Speeds {
  std::string commit, processor;
  int ranks = 1;
  std::vector<Speed> results;
};

nlohmann::ordered_json to_json(const Speeds& speeds);
/// @throws InputError where it is no such file
Speeds read_speeds(const std::string& path);

/// A line for each result: time, million cells per second, GB/s and what part of the triad's rate
/// that is; with `before`, how many times as fast it was then.
std::string speed_table(const Speeds& now, const Speeds* before = nullptr);

}  // namespace washtub
