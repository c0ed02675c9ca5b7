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

/// Most points that a kernel reaches.
inline constexpr int kernel_points = 4;
/// Points that this one reaches.
constexpr int points_of(Kernel kernel) { return kernel == Kernel::roma3 ? 3 : kernel_points; }

/// Weights h phi of the grid points from `start` on; those that the kernel does not reach have 0.
struct KernelLine {
  int start;
  std::array<double, kernel_points> weight;
};

/// Thickness of the layer of water that moves with a sheet, 1 / integral of phi^2, in cells.
double kernel_thickness(Kernel kernel);

/// h phi at a distance of r cells.
double kernel_value(Kernel kernel, double r);

/// Weights of a marker at x cells.
KernelLine kernel_line(Kernel kernel, double x);

/// Weights of a marker on faces and on cell centres, point i of which lies half a cell beyond face
/// i: kernel_line at x and at x - 1/2, at less cost.
struct KernelPair {
  KernelLine face, centre;
};
KernelPair kernel_pair(Kernel kernel, double x);

}  // namespace washtub
