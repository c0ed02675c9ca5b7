#include "measure/stress.hpp"

#include <cmath>

namespace washtub {

StressParts area_mean(const StressField& stress, std::span<const double> area) {
  return {area_mean(stress.membrane, area), area_mean(stress.bending, area),
          area_mean(stress.total, area)};
}

void StressStatistics::Parts::add(const StressParts& value, double weight) {
  membrane.add(value.membrane, weight);
  bending.add(value.bending, weight);
  total.add(value.total, weight);
}

void StressStatistics::Parts::add(const Parts& others) {
  membrane.add(others.membrane);
  bending.add(others.bending);
  total.add(others.total);
}

StressStatistics::StressStatistics(std::size_t pieces, const Interval& window)
    : window_(window), of_piece_(pieces) {}

void StressStatistics::add(const Interval& over, std::span<const StressParts> pieces) {
  const double time = window_.overlap(over);
  if (time <= 0 || pieces.empty()) return;
  StressParts sum;
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    of_piece_[k].add(pieces[k], time);
    sum.membrane += pieces[k].membrane;
    sum.bending += pieces[k].bending;
    sum.total += pieces[k].total;
  }
  const double n = static_cast<double>(pieces.size());
  of_all_.add({sum.membrane / n, sum.bending / n, sum.total / n}, time);
}

void StressStatistics::add(const StressStatistics& others) {
  for (std::size_t k = 0; k < of_piece_.size(); ++k) of_piece_[k].add(others.of_piece_[k]);
  of_all_.add(others.of_all_);
}

StressSummary StressStatistics::summary(Statistics Parts::*part) const {
  Statistics means, variances;
  for (const Parts& piece : of_piece_) {
    const Statistics& s = piece.*part;
    means.add(s.mean());
    variances.add(s.deviation() * s.deviation());
  }
  const double pooled = std::hypot(means.deviation(), std::sqrt(variances.mean()));
  return {means.mean(), (of_all_.*part).deviation(), means.deviation(), pooled};
}

}  // namespace washtub
