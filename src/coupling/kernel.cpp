#include "coupling/kernel.hpp"

#include <cmath>
#include <numbers>

namespace washtub {
namespace {

double cosine(double r) { return r < 2 ? 0.25 * (1 + std::cos(0.5 * std::numbers::pi * r)) : 0; }

double roma3(double r) {
  if (r < 0.5) return (1 + std::sqrt(1 - 3 * r * r)) / 3;
  if (r < 1.5) return (5 - 3 * r - std::sqrt(1 - 3 * (1 - r) * (1 - r))) / 6;
  return 0;
}

double peskin4(double r) {
  if (r < 1) return (3 - 2 * r + std::sqrt(1 + 4 * r - 4 * r * r)) / 8;
  if (r < 2) return (5 - 2 * r - std::sqrt(-7 + 12 * r - 4 * r * r)) / 8;
  return 0;
}

/// The four cosines differ by quarter turns, so one sine and cosine give all.
std::array<double, kernel_points> cosine_weights(double fraction) {
  const double a = 0.5 * std::numbers::pi * fraction;
  const double c = 0.25 * std::cos(a), s = 0.25 * std::sin(a);
  return {0.25 - s, 0.25 + c, 0.25 + s, 0.25 - c};
}

}  // namespace

double kernel_value(Kernel kernel, double r) {
  r = std::abs(r);
  switch (kernel) {
    case Kernel::cosine:
      return cosine(r);
    case Kernel::roma3:
      return roma3(r);
    case Kernel::peskin4:
      return peskin4(r);
  }
  return 0;
}

std::array<double, kernel_points> kernel_weights(Kernel kernel, double x) {
  const double fraction = x - std::floor(x);
  if (kernel == Kernel::cosine) return cosine_weights(fraction);
  std::array<double, kernel_points> w;
  for (int m = 0; m < kernel_points; ++m) w[m] = kernel_value(kernel, fraction - (m - 1));
  return w;
}

}  // namespace washtub
