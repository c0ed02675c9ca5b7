#include <gtest/gtest.h>

#include "flow/annulus.hpp"

namespace washtub {
namespace {

using testing::annulus;
using testing::WaterBox;

/// Steady circular Couette flow, App. B and reference.md, section 5; r_o = Omega_o = rho = 1.
struct Couette {
  static constexpr double r_i = 0.34, omega_i = 6.13, width = 2.82;
  static constexpr double viscosity = (1 - r_i) / 131, torque = 0.04245;

  static double speed(double r) { return 0.32946 * r + 0.67054 / r; }  // Eq. (A.12)
  double operator()(int d, const Vec<2>& x) const {
    const double r = x.norm();
    if (r <= r_i) return omega_i * (d == 0 ? -x[1] : x[0]);
    return (r < 1 ? speed(r) / r : 1.0) * (d == 0 ? -x[1] : x[0]);
  }
};

struct Errors {
  double largest = 0,
         rms = 0;             ///< of the velocity, Eq. (A.13), over the faces between ring and disc
  double ring = 0, disc = 0;  ///< torque over the exact one, less one
};

/// Starts from the exact solution and lets it settle: a tenth of the diffusive time of the gap is
/// enough for an error that lives at the surfaces.
Errors couette_errors(int n, double gamma_cells, double time) {
  WaterBox<2> box(annulus(Couette::width, n, Couette::r_i, constant_speed(Couette::omega_i),
                          constant_speed(1), Couette::viscosity, gamma_cells));
  box.start_from(Couette());
  const double dt = 0.25 * (Couette::width / n) / (Couette::omega_i * Couette::r_i);
  while (box.t < time) EXPECT_TRUE(box.step(dt, 1e-6).pressure.converged);

  Errors e;
  std::array<double, 2> sums{};
  box.for_open_faces([&](int d, const Vec<2>& x, long p) {
    const double r = x.norm();
    if (r <= Couette::r_i || r >= 1) return;
    const double error = (box.flow.velocity()[d][p] - Couette()(d, x)) / Couette::speed(r);
    e.largest = std::max(e.largest, std::abs(error));
    sums[0] += error * error;
    sums[1] += 1;
  });
  box.grid.parallel().sum(std::span<double>(sums));
  e.largest = box.grid.parallel().max(e.largest);
  e.rms = std::sqrt(sums[0] / sums[1]);
  e.ring = box.torque(0) / Couette::torque - 1;
  e.disc = -box.torque(1) / Couette::torque - 1;
  std::printf("couette n %d gamma %g t %g: max %.4f rms %.5f ring %+.4f disc %+.4f\n", n,
              gamma_cells, time, e.largest, e.rms, e.ring, e.disc);
  return e;
}

TEST(VerificationCouette, Sharp128) {
  for (double t : {1, 2, 5, 10}) couette_errors(128, 0, t);
}
TEST(VerificationCouette, Smooth128) {
  for (double t : {1, 2, 5, 10}) couette_errors(128, 2, t);
}
TEST(VerificationCouette, Sharp256) {
  for (double t : {1, 2}) couette_errors(256, 0, t);
}
TEST(VerificationCouette, Smooth256) {
  for (double t : {1, 2}) couette_errors(256, 2, t);
}

}  // namespace
}  // namespace washtub
