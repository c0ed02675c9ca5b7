#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "support/water_box.hpp"

namespace washtub {
namespace {

using testing::cubic_mesh;
using testing::WaterBox;
using testing::WaterSetup;

/// Taylor-Green vortex carried along by a uniform stream: an exact solution in which convection
/// and pressure do not cancel cell by cell, as they do for the vortex at rest.
struct CarriedVortex {
  static constexpr double viscosity = 0.05, stream_x = 1, stream_y = 0.5;
  double t;
  double operator()(int d, const Vec<2>& x) const {
    const double decay = std::exp(-2 * viscosity * t);
    const double a = x[0] - stream_x * t, b = x[1] - stream_y * t;
    return d == 0 ? stream_x + decay * std::sin(a) * std::cos(b)
                  : stream_y - decay * std::cos(a) * std::sin(b);
  }
};

std::unique_ptr<WaterBox<2>> run(int n, int steps, double time) {
  auto box = std::make_unique<WaterBox<2>>(
      WaterSetup<2>{.mesh = cubic_mesh<2>(Vec<2>::Zero(), 2 * std::numbers::pi, n, true),
                    .viscosity = CarriedVortex::viscosity});
  box->start_from(CarriedVortex{0});
  for (int s = 0; s < steps; ++s) box->step(time / steps, 1e-11);
  return box;
}

/// A quarter of the error on half the spacing (4.0 in the limit).
TEST(VerificationTaylorGreen, SecondOrderInSpace) {
  std::array<double, 3> e;
  for (int i = 0; i < 3; ++i) e[i] = run(16 << i, 400, 0.5)->error(CarriedVortex{0.5});
  EXPECT_GT(e[0] / e[1], 3.6);
  EXPECT_GT(e[1] / e[2], 3.6);
  EXPECT_LE(e[2], 2e-3);
}

double difference(const WaterBox<2>& a, const WaterBox<2>& b) {
  double largest = 0;
  for (int d = 0; d < 2; ++d)
    a.for_cells([&](const Index<2>&, long p) {
      largest = std::max(largest, std::abs(a.flow.velocity()[d][p] - b.flow.velocity()[d][p]));
    });
  return a.grid.parallel().max(largest);
}

/// Differences between steps dt, dt/2, dt/4 on one grid fall fourfold.
TEST(VerificationTaylorGreen, SecondOrderInTime) {
  const auto coarse = run(32, 20, 1), medium = run(32, 40, 1), fine = run(32, 80, 1);
  const double first = difference(*coarse, *medium), second = difference(*medium, *fine);
  EXPECT_GT(first / second, 3.6);
  EXPECT_LT(first / second, 4.6);
}

}  // namespace
}  // namespace washtub
