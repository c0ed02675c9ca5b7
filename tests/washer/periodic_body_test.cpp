#include <gtest/gtest.h>

#include "washer/simulation.hpp"

namespace washtub {
namespace {

/// A paddle that turns in a stream through a box that is periodic along x.
Case stream(const std::string& x, const std::string& drive, const std::string& mapping) {
  return read_case_text(
      R"(dimension = 2
[fluid]
density = "1 kg/m^3"
viscosity = "1e-2 Pa s"
velocity = ["1", "0"]
[domain]
size = ["2 m", "1 m"]
cells = [64, 32]
mapping = ")" +
          mapping +
          R"("
[domain.sides]
x_lower = "periodic"
x_upper = "periodic"
y_lower = "slip"
y_upper = "slip"
[[solid]]
name = "paddle"
shape = { kind = "box", lower = ["-31 cm", "-7 cm"], upper = ["22 cm", "9 cm"] }
centre = [")" +
          x +
          R"(", "0.5 m"]
drive = )" +
          drive +
          R"(
[time]
end = "1 s"
step = "5 ms"
[solver]
divergence = 1e-11
[scale]
speed = "1 rad/s"
length = "1 m"
)",
      "stream.toml");
}

struct Result {
  Vec<2> force;
  double torque, moment, kinetic, driving_speed;
};

Result run(const Case& whole) {
  Simulation<2> simulation(whole, Parallel());
  for (int i = 0; i < 40; ++i) simulation.step(1);
  const Load<2> load = simulation.loads(0).total();
  return {load.force, load.torque, simulation.take_impulse(0).moment, simulation.last().kinetic,
          simulation.driving_speed()};
}

/// What a body feels does not depend on where in a periodic box it is.
void expect_equal_everywhere(const std::string& drive, const std::string& mapping) {
  const Result middle = run(stream("1 m", drive, mapping));
  EXPECT_GT(std::abs(middle.force[0]), 0.1);
  for (const char* x : {"0 m", "0.25 m", "2 m", "5 m", "1.875 m"}) {
    const Result here = run(stream(x, drive, mapping));
    EXPECT_NEAR(here.force[0], middle.force[0], 1e-6 * middle.force.norm()) << x;
    EXPECT_NEAR(here.force[1], middle.force[1], 1e-6 * middle.force.norm()) << x;
    EXPECT_NEAR(here.torque, middle.torque, 1e-6 * middle.force.norm()) << x;
    EXPECT_NEAR(here.moment, middle.moment, 1e-4 * std::abs(middle.moment)) << x;
    EXPECT_NEAR(here.kinetic, middle.kinetic, 1e-6 * middle.kinetic) << x;
    EXPECT_NEAR(here.driving_speed, middle.driving_speed, 1e-12) << x;
  }
}

TEST(PeriodicBody, FeelsTheSameEverywhere) {
  expect_equal_everywhere("{ kind = \"rest\" }", "sharp");
}

TEST(PeriodicBody, TurnsTheSameEverywhere) {
  expect_equal_everywhere("{ kind = \"constant\", speed = \"30 rpm\" }", "sharp");
  expect_equal_everywhere("{ kind = \"constant\", speed = \"30 rpm\" }", "smooth");
}

}  // namespace
}  // namespace washtub
