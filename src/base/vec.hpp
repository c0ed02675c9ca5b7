#pragma once
#include <Eigen/Core>
#include <array>

namespace washtub {

/// A point or vector of D-dimensional space [m, m/s, N, ...].
template <int D>
using Vec = Eigen::Matrix<double, D, 1>;

/// A matrix that maps such vectors onto each other [N/m, ...].
template <int D>
using Mat = Eigen::Matrix<double, D, D>;

/// Counts or positions along the D axes of a grid.
template <int D>
using Index = std::array<int, D>;

}  // namespace washtub
