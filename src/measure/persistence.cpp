#include "measure/persistence.hpp"

#include <algorithm>
#include <iterator>

namespace washtub {
namespace {

constexpr double slack = 1e-3;  // of the span, by which instants may miss it

std::size_t in_common(const Persistence::Pairs& a, const Persistence::Pairs& b) {
  Persistence::Pairs both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
  return both.size();
}

}  // namespace

void Persistence::add(double time, const Pairs& pairs) {
  if (!(span_ > 0)) return;
  kept_.push_back({time, pairs});
  while (time - kept_.front().time >= (1 - slack) * span_) {
    const Instant& then = kept_.front();
    if (time - then.time <= (1 + slack) * span_) {
      before_ += static_cast<double>(then.pairs.size());
      still_ += static_cast<double>(in_common(then.pairs, pairs));
    }
    kept_.pop_front();
  }
}

void Persistence::state(Archive& archive) {
  std::vector<double> times;
  std::vector<int> lengths, numbers;
  for (const Instant& instant : kept_) {
    times.push_back(instant.time);
    lengths.push_back(static_cast<int>(instant.pairs.size()));
    for (const auto& [a, b] : instant.pairs) numbers.insert(numbers.end(), {a, b});
  }
  archive.value("times", times);
  archive.value("lengths", lengths);
  archive.value("pairs", numbers);
  archive.value("before", before_);
  archive.value("still", still_);
  if (!archive.reading()) return;
  kept_.clear();
  auto next = numbers.begin();
  for (std::size_t i = 0; i < times.size(); ++i) {
    kept_.push_back({times[i], {}});
    for (int k = 0; k < lengths[i]; ++k, next += 2)
      kept_.back().pairs.emplace_back(next[0], next[1]);
  }
}

}  // namespace washtub
