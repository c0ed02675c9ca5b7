#include <gtest/gtest.h>

#include "flow/annulus.hpp"
#include "support/wash_tub.hpp"

namespace washtub {
namespace {

using testing::annulus;
using testing::WaterBox;

struct Torques {
  double ring = 0, disc = 0;  ///< root mean square over a cycle, over rho r_o^4 omega_max^2
};

/// The tub's own drive on a disc of radius 0.7 in a ring, r_o = omega_max = rho = 1; rms torque of
/// the last cycle.
Torques rms_torques(double reynolds, int n, int cycles) {
  const double width = 2.171, frequency = 2 / std::numbers::pi / testing::peak_speed;
  WaterBox<2> box(annulus(width, n, 0.7, sinusoid(1, frequency), at_rest(), 1 / reynolds));
  const int steps = static_cast<int>(std::ceil(0.7 * n / (0.4 * width * frequency)));  // CFL 0.4
  Torques squares;
  for (int s = 0; s < cycles * steps; ++s) {
    box.step(1 / (frequency * steps));
    if (s < (cycles - 1) * steps) continue;
    squares.ring += std::pow(box.torque(0), 2) / steps;
    squares.disc += std::pow(box.torque(1), 2) / steps;
  }
  return {std::sqrt(squares.ring), std::sqrt(squares.disc)};
}

/// Exact torques: reference.md, section 5. On staircase surfaces with 9 or 18 cells across the gap
/// the tolerances are what a shift of the surface by a fraction of a cell costs.
TEST(VerificationOscillatingCouette, TorqueAtReynolds1276) {
  const auto coarse = rms_torques(1275.6, 64, 4);
  EXPECT_NEAR(coarse.ring / 1.138e-3, 1, 0.05);
  EXPECT_NEAR(coarse.disc / 2.60e-2, 1, 0.1);
  const auto fine = rms_torques(1275.6, 128, 2);
  EXPECT_NEAR(fine.ring / 1.138e-3, 1, 0.16);
  EXPECT_NEAR(fine.disc / 2.60e-2, 1, 0.07);
}
TEST(VerificationOscillatingCouette, TorqueAtReynolds121) {
  const auto coarse = rms_torques(120.8, 64, 2);
  EXPECT_NEAR(coarse.ring / 6.64e-2, 1, 0.12);
  EXPECT_NEAR(coarse.disc / 9.20e-2, 1, 0.1);
  const auto fine = rms_torques(120.8, 128, 1);
  EXPECT_NEAR(fine.ring / 6.64e-2, 1, 0.1);
  EXPECT_NEAR(fine.disc / 9.20e-2, 1, 0.1);
}

}  // namespace
}  // namespace washtub
