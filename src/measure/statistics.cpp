#include "measure/statistics.hpp"

#include <cmath>
#include <limits>

namespace washtub {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

void Statistics::add(double value, double weight) {
  if (!(weight > 0)) return;
  weight_ += weight;
  const double from_old = value - mean_;
  mean_ += from_old * weight / weight_;
  squares_ += weight * from_old * (value - mean_);
}

/// Chan, Golub and LeVeque, Am. Stat. 37, 1983.
void Statistics::add(const Statistics& others) {
  if (!(others.weight_ > 0)) return;
  const double before = weight_, apart = others.mean_ - mean_;
  weight_ += others.weight_;
  mean_ += apart * others.weight_ / weight_;
  squares_ += others.squares_ + apart * apart * before * others.weight_ / weight_;
}

double Statistics::mean() const { return weight_ > 0 ? mean_ : unknown; }

double Statistics::deviation() const {
  return weight_ > 0 ? std::sqrt(squares_ / weight_) : unknown;
}

double Statistics::rms() const { return std::hypot(mean(), deviation()); }

}  // namespace washtub
