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
  std::printf("Re %g n %d cycles %d: ring %.4e disc %.4e\n", reynolds, n, cycles,
              std::sqrt(squares.ring), std::sqrt(squares.disc));
  return {std::sqrt(squares.ring), std::sqrt(squares.disc)};
}

TEST(VerificationOscillatingCouette, Re1276) {
  for (int c : {1, 2, 3, 5}) rms_torques(1275.6, 64, c);
  rms_torques(1275.6, 128, 2);
}
TEST(VerificationOscillatingCouette, Re121) {
  for (int c : {1, 2, 3, 5}) rms_torques(120.8, 64, c);
  rms_torques(120.8, 128, 2);
}

}  // namespace
}  // namespace washtub
