#pragma once
#include <Eigen/Geometry>
#include <array>
#include <vector>

#include "base/vec.hpp"

namespace washtub {

/// Of a triangle, twice its area long; of a segment, as long as it.
template <int D>
Vec<D> face_normal(const std::array<int, D>& face, const std::vector<Vec<D>>& x) {
  const auto at = [&](std::size_t k) -> const Vec<D>& {
    return x[static_cast<std::size_t>(face[k])];
  };
  const Vec<D> a = at(1) - at(0);
  if constexpr (D == 3)
    return a.cross(at(2) - at(0));
  else
    return Vec<D>(-a[1], a[0]);
}

}  // namespace washtub
