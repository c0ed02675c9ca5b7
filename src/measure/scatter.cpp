#include "measure/scatter.hpp"

#include <cmath>

namespace washtub {

void Scatter::add(const Scatter& others) {
  for (std::size_t k = 0; k < r_.size(); ++k) {
    r_[k].add(others.r_[k]);
    z_[k].add(others.z_[k]);
  }
}

Vec<2> Scatter::centre(std::size_t piece) const { return {r_[piece].mean(), z_[piece].mean()}; }

Vec<2> Scatter::centre() const {
  Statistics r, z;
  for (std::size_t k = 0; k < r_.size(); ++k) {
    r.add(r_[k].mean(), r_[k].weight());
    z.add(z_[k].mean(), z_[k].weight());
  }
  return {r.mean(), z.mean()};
}

template <class Centre>
double Scatter::rms_distance(const Centre& about) const {
  Statistics squares;
  for (std::size_t k = 0; k < r_.size(); ++k) {
    const Vec<2> deviation(r_[k].deviation(), z_[k].deviation());
    squares.add(deviation.squaredNorm() + (centre(k) - about(k)).squaredNorm(), r_[k].weight());
  }
  return std::sqrt(squares.mean());
}

double Scatter::own_about(const Scatter& other) const {
  return rms_distance([&](std::size_t piece) { return other.centre(piece); });
}

double Scatter::common_about(const Scatter& other) const {
  const Vec<2> middle = other.centre();
  return rms_distance([&](std::size_t) { return middle; });
}

}  // namespace washtub
