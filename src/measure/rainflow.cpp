#include "measure/rainflow.hpp"

#include <algorithm>
#include <string>

namespace washtub {

Rainflow::Rainflow(std::size_t signals)
    : signals_(signals),
      lowest_(signals * bounds),
      highest_(signals * bounds),
      direction_(signals * bounds),
      begun_(signals) {}

void Rainflow::add(std::size_t signal, double value) {
  const bool first = !begun_[signal];
  begun_[signal] = 1;
  for (std::size_t k = 0; k < bounds; ++k) {
    const std::size_t i = signal * bounds + k;
    lowest_[i] = first ? value : std::min(lowest_[i], value);
    highest_[i] = first ? value : std::max(highest_[i], value);
    const bool rises = value - lowest_[i] >= strain_ranges[k] && direction_[i] != 1;
    const bool falls = highest_[i] - value >= strain_ranges[k] && direction_[i] != -1;
    if (!rises && !falls) continue;
    counts_[k] += 0.5;
    direction_[i] = rises ? 1 : -1;
    lowest_[i] = highest_[i] = value;
  }
}

Rainflow::Counts Rainflow::take() {
  Counts since = counts_;
  for (std::size_t k = 0; k < since.size(); ++k) since[k] -= taken_[k];
  taken_ = counts_;
  return since;
}

void Rainflow::state(Archive& archive) {
  archive.same_length("lowest", lowest_);
  archive.same_length("highest", highest_);
  archive.same_length("direction", direction_);
  archive.same_length("begun", begun_);
  for (std::size_t k = 0; k < bounds; ++k) {
    archive.value("counts " + std::to_string(k), counts_[k]);
    archive.value("taken " + std::to_string(k), taken_[k]);
  }
}

}  // namespace washtub
