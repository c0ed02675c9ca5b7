#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "washer/simulation.hpp"

using namespace washtub;

namespace {

/// A heavy cloth on the floor of a box that is tilted, in a fluid that hardly matters.
Case slope(double degrees, double friction) {
  const double angle = degrees * std::numbers::pi / 180;
  return read_case_text(fmt::format(R"(
[fluid]
density = "0.01 kg/m^3"
viscosity = "1e-6 Pa s"
gravity = ["{} m/s^2", "0 m/s^2", "{} m/s^2"]
[domain]
size = ["64 cm", "32 cm", "16 cm"]
cells = [32, 16, 8]
[[cloth]]
arrangement = "sheet"
origin = ["12 cm", "8 cm", "1 cm"]
along_r = [1, 0, 0]
along_s = [0, 1, 0]
size = ["16 cm", "16 cm"]
excess_mass = "0.3 kg/m^2"
stretch_stiffness = "1e3 N/m"
shear_stiffness = "1e2 N/m"
bending_stiffness = "1e-5 N m"
torsion_stiffness = "1e-5 N m"
thickness = "1 mm"
solid_friction = {}
[time]
end = "60 s"
step = "5 ms"
)",
                                    9.81 * std::sin(angle), -9.81 * std::cos(angle), friction),
                        "slope");
}

double middle(const Simulation<3>& simulation) {
  double sum = 0;
  for (const auto& x : simulation.cloth().position) sum += x[0];
  return sum / simulation.cloth().nodes();
}

}  // namespace

/// Ten seconds on a slope of 3 degrees less than the angle of friction, of 26.6 degrees.
TEST(VerificationSlope, ClothStaysBelowTheAngleOfFriction) {
  Simulation<3> simulation(slope(23.6, 0.5), Parallel());
  while (simulation.time() < 1) simulation.step(1);
  const double settled = middle(simulation);
  while (simulation.time() < 10) simulation.step(10);
  EXPECT_NEAR(middle(simulation), settled, 1e-5);
}

/// Above it the acceleration is g (sin - friction cos).
TEST(Slope, ClothSlidesAboveTheAngleOfFriction) {
  const double angle = 35 * std::numbers::pi / 180;
  for (const double friction : {0.0, 0.3, 0.5}) {
    Simulation<3> simulation(slope(35, friction), Parallel());
    while (simulation.time() < 0.2) simulation.step(0.2);
    const double start = middle(simulation);
    double speed = 0;
    for (const auto& v : simulation.cloth().velocity) speed += v[0] / simulation.cloth().nodes();
    constexpr double t = 0.1;
    while (simulation.time() < 0.2 + t) simulation.step(0.2 + t);
    const double pull = 9.81 * std::sin(angle), a = pull - friction * 9.81 * std::cos(angle);
    EXPECT_NEAR(2 * (middle(simulation) - start - speed * t) / (t * t), a, 0.02 * pull) << friction;
  }
}
