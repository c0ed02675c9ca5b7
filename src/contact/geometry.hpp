#pragma once
#include <array>

#include "base/vec.hpp"

namespace washtub {

/// Barycentric weights of the point of a segment (in the plane) or triangle (in space) nearest to
/// x.
std::array<double, 2> nearest_weights(const Vec<2>& x, const std::array<Vec<2>, 2>& segment);
std::array<double, 3> nearest_weights(const Vec<3>& x, const std::array<Vec<3>, 3>& triangle);

/// Where two segments ab and cd are nearest: as a + s (b - a) and c + t (d - c).
std::array<double, 2> nearest_parameters(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c,
                                         const Vec<3>& d);

}  // namespace washtub
