#pragma once
#include <random>

#include "base/vec.hpp"

namespace washtub {

/// Seeded random points of a cube [-size, size]^3.
class Points {
 public:
  explicit Points(double size) : coordinate_(-size, size) {}
  Vec<3> next() {
    const double x = coordinate_(engine_), y = coordinate_(engine_);
    return {x, y, coordinate_(engine_)};
  }

 private:
  std::mt19937 engine_{7};
  std::uniform_real_distribution<double> coordinate_;
};

}  // namespace washtub
