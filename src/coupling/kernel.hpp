#pragma once
#include <array>
#include <string_view>

namespace washtub {

/// Regularised one-dimensional delta functions phi, the factors of Eq. (7).
enum class Kernel {
  cosine,   ///< Eq. (8) with half width 2 h (Peskin 1977)
  roma3,    ///< three points (Roma, Peskin & Berger 1999)
  peskin4,  ///< four points (Peskin 2002)
};

/// Points a kernel can reach; those beyond a narrower kernel get weight 0.
inline constexpr int kernel_points = 4;

/// h phi at a distance of r cells.
double kernel_value(Kernel kernel, double r);

/// Weights h phi of the grid points floor(x) - 1 ... floor(x) + 2 for a marker at x cells.
std::array<double, kernel_points> kernel_weights(Kernel kernel, double x);

}  // namespace washtub
