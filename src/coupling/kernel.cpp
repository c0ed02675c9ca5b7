#include "coupling/kernel.hpp"

#include <cmath>
#include <numbers>
#include <utility>

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

/// Weights by the four cosines, which differ by quarter turns.
KernelLine four_cosines(int start, double cosine, double sine) {
  return {start,
          {0.25 - 0.25 * sine, 0.25 + 0.25 * cosine, 0.25 + 0.25 * sine, 0.25 - 0.25 * cosine}};
}

// From x^3 and x^2 on.
constexpr std::array<double, 7> sine_series = {
    -1.0 / 6,        1.0 / 120,        -1.0 / 5040,         1.0 / 362880,
    -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000};
constexpr std::array<double, 8> cosine_series = {
    -1.0 / 2,       1.0 / 24,        -1.0 / 720,         1.0 / 40320,
    -1.0 / 3628800, 1.0 / 479001600, -1.0 / 87178291200, 1.0 / 20922789888000};

/// Sine and cosine of |x| <= pi / 4 to the last digit or two, by their series.
std::pair<double, double> sine_cosine(double x) {
  const double y = x * x;
  double s = sine_series.back(), c = cosine_series.back();
  for (std::size_t i = sine_series.size() - 1; i-- > 0;) s = s * y + sine_series[i];
  for (std::size_t i = cosine_series.size() - 1; i-- > 0;) c = c * y + cosine_series[i];
  return {x + x * y * s, 1 + y * c};
}

/// Both lie an eighth of a turn apart, on either side of the middle between two faces.
KernelPair cosine_pair(double x) {
  const double whole = std::floor(x), from_middle = x - whole - 0.5;
  const int start = static_cast<int>(whole) - 1;
  const auto [s, c] = sine_cosine(0.5 * std::numbers::pi * from_middle);
  constexpr double half = 0.5 * std::numbers::sqrt2;
  return {four_cosines(start, half * (c - s), half * (c + s)),
          from_middle < 0 ? four_cosines(start - 1, -s, c) : four_cosines(start, c, s)};
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

KernelLine kernel_line(Kernel kernel, double x) {
  const int points = points_of(kernel);
  const double first = std::floor(points == 3 ? x - 0.5 : x - 1);
  KernelLine line{static_cast<int>(first), {}};
  for (int m = 0; m < points; ++m) line.weight[m] = kernel_value(kernel, x - first - m);
  return line;
}

KernelPair kernel_pair(Kernel kernel, double x) {
  if (kernel == Kernel::cosine) return cosine_pair(x);
  return {kernel_line(kernel, x), kernel_line(kernel, x - 0.5)};
}

double kernel_thickness(Kernel kernel) {
  constexpr int parts = 1000;  // of a cell
  double squares = 0;
  for (int i = -2 * parts; i < 2 * parts; ++i) {
    const double value = kernel_value(kernel, (i + 0.5) / parts);
    squares += value * value / parts;
  }
  return 1 / squares;
}

}  // namespace washtub
