#include "measure/scatter.hpp"

#include <cmath>

namespace washtub {

Vec<2> Scatter::centre(std::size_t piece) const { return {r_[piece].mean(), z_[piece].mean()}; }

Vec<2> Scatter::centre() const {
  Statistics r, z;
  for (std::size_t k = 0; k < r_.size(); ++k) {
    r.add(r_[k].mean(), r_[k].weight());
    z.add(z_[k].mean(), z_[k].weight());
  }
  return {r.mean(), z.mean()};
}

double Scatter::own() const {
  Statistics squares;
  for (std::size_t k = 0; k < r_.size(); ++k) {
    const double r = r_[k].deviation(), z = z_[k].deviation();
    squares.add(r * r + z * z, r_[k].weight());
  }
  return std::sqrt(squares.mean());
}

double Scatter::common() const {
  const Vec<2> middle = centre();
  Statistics squares;
  for (std::size_t k = 0; k < r_.size(); ++k)
    squares.add((centre(k) - middle).squaredNorm(), r_[k].weight());
  return std::hypot(own(), std::sqrt(squares.mean()));
}

}  // namespace washtub
