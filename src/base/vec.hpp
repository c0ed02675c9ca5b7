#pragma once
#include <Eigen/Core>
#include <array>

namespace washtub {

/// A point or vector of D-dimensional space [m, m/s, N, ...].
template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

/// Counts or positions along the D axes of a grid.
template <int D>
using Index = std::array<int, D>;

}  // namespace washtub
