#include "measure/rainflow.hpp"

#include <cmath>
#include <string>

namespace washtub {

void Rainflow::add(std::size_t signal, double value) {
  auto& turns = turns_[signal];
  const auto n = turns.size();
  const bool goes_on = n >= 2 && (value - turns[n - 1]) * (turns[n - 1] - turns[n - 2]) >= 0;
  if (goes_on)
    turns.back() = value;
  else if (n == 0 || value != turns.back())
    turns.push_back(value);
  while (turns.size() >= 4) {
    const double* last = &turns.back();
    const double range = std::abs(last[-1] - last[-2]);
    if (range > std::abs(last[0] - last[-1]) || range > std::abs(last[-2] - last[-3])) break;
    for (std::size_t k = 0; k < strain_ranges.size(); ++k) counts_[k] += range >= strain_ranges[k];
    turns.erase(turns.end() - 3, turns.end() - 1);
  }
}

Rainflow::Counts Rainflow::take() {
  Counts since = counts_;
  for (std::size_t k = 0; k < since.size(); ++k) since[k] -= taken_[k];
  taken_ = counts_;
  return since;
}

void Rainflow::state(Archive& archive) {
  std::vector<int> lengths;
  std::vector<double> all;
  for (const auto& turns : turns_) {
    lengths.push_back(static_cast<int>(turns.size()));
    all.insert(all.end(), turns.begin(), turns.end());
  }
  archive.same_length("lengths", lengths);
  for (std::size_t k = 0; k < counts_.size(); ++k) {
    archive.value("counts " + std::to_string(k), counts_[k]);
    archive.value("taken " + std::to_string(k), taken_[k]);
  }
  archive.value("turns", all);
  if (!archive.reading()) return;
  auto from = all.begin();
  for (std::size_t s = 0; s < turns_.size(); ++s) {
    turns_[s].assign(from, from + lengths[s]);
    from += lengths[s];
  }
}

}  // namespace washtub
