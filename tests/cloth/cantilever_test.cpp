#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "cloth/implicit.hpp"
#include "cloth/thread.hpp"

using namespace washtub;

namespace {

constexpr double g = 9.81;

/// Angle below the horizontal of the line from the clamp to the tip of a strip that hangs over a
/// clamp by `length`, its weight w per area; two rows of nodes are held, the clamp is between them.
double hang(const Sheet<2>& sheet, double length, double w) {
  const int rows = sheet.nodes();
  const double step = length / (rows - 1.5);
  std::vector<int> held;
  std::vector<Vec<2>> X, Z(static_cast<std::size_t>(sheet.nodes())), F(Z.size());
  for (int n = 0; n < rows; ++n) {
    X.emplace_back((n - 0.5) * step, 0);
    if (n < 2) held.push_back(n);
  }
  ClothSolver<2> solver(sheet, held);
  // Each solve goes down the energy, with a spring that keeps it near; where it stands still there
  // is no force of the spring.
  const double spring = 0.5 * w * sheet.area[0] / step;
  const std::vector<Mat<2>> K(X.size(), spring * Mat<2>::Identity());
  for (int k = 0; k < 1500; ++k) {
    Z = X;
    for (std::size_t n = 0; n < Z.size(); ++n)
      if (n >= 2) Z[n][1] -= w * sheet.area[n] / spring;
    solver.solve(std::vector{0}, {K, Z, X, 0}, X, F);
  }
  const Vec<2> tip = X[static_cast<std::size_t>(rows - 1)];
  return std::atan2(-tip[1], tip[0]) * 180 / std::numbers::pi;
}

/// The same of an inextensible strip: B a'' = -w (l - s) cos a, a(0) = 0, a'(l) = 0, by shooting.
double heavy_elastica(double length_cubed_w_over_B) {
  constexpr int n = 4000;
  const auto shoot = [&](double slope, double& x, double& y) {
    double a = 0, b = slope;
    x = y = 0;
    for (int i = 0; i < n; ++i) {
      const double s = (i + 0.5) / n, half = a + 0.5 * b / n;
      b -= length_cubed_w_over_B * (1 - s) * std::cos(half) / n;
      a += b / n;
      x += std::cos(half) / n;
      y += std::sin(half) / n;
    }
    return b;
  };
  double low = 0, high = length_cubed_w_over_B, x = 0, y = 0;
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (shoot(middle, x, y) > 0 ? high : low) = middle;
  }
  return std::atan2(y, x) * 180 / std::numbers::pi;
}

struct Strip {
  double mass, stretch, bending;
};
constexpr Strip cotton_sheet{0.150, 3000, 1e-5}, denim{0.324, 3400, 2e-5};

}  // namespace

/// ASTM D1388: a strip whose tip is seen under 41.5 degrees hangs over by twice its bending length
/// c = (B/w)^(1/3). The heavy elastica says 41.48 degrees.
TEST(Cantilever, HangsByTwiceItsBendingLength) {
  EXPECT_NEAR(heavy_elastica(8), 41.5, 0.1);
  for (const Strip& strip : {cotton_sheet, denim}) {
    const double w = strip.mass * g, length = 2 * std::cbrt(strip.bending / w);
    const double step = length / 14.5;
    const Material material{strip.stretch, 0, strip.bending, 0, 0, 0, 5e-4};
    EXPECT_NEAR(hang(make_thread(16, step, material), length, w), heavy_elastica(8), 0.7);
  }
}
