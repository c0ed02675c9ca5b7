#include "washer/resolution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "washer/simulation.hpp"

namespace washtub {
namespace {

using ::testing::HasSubstr;

Case wash(const std::string& viscosity, const std::string& cells = "32") {
  return read_case("cases/wash-3d/case.toml",
                   {"fluid.viscosity=" + viscosity, "domain.cells=" + cells});
}

TEST(Resolution, SaysNothingOfResolvedFlows) {
  EXPECT_FALSE(unresolved({0.10, 4.9, 2.72}, wash("1 Pa s")));
  EXPECT_FALSE(unresolved({}, wash("1 Pa s")));
}

TEST(Resolution, SaysWhatWasMeasuredAndWhatHelps) {
  EXPECT_EQ(unresolved({0.3789, 11.5, 2.72}, wash("1e-3 Pa s")).value_or(""),
            "The grid does not resolve this flow: up to 38 % of the water's kinetic energy "
            "alternates from cell to cell (below 15 % is good, white noise has 37.5 %), and the "
            "water reaches 11.5 m/s, 4.2 times the 2.72 m/s of what drives it. Torque, stress and "
            "motion of such a run mean little; try a fluid.viscosity of 0.17 Pa s or more on this "
            "grid, or 1.7e+02 times as many domain.cells along every axis.");
  EXPECT_THAT(*unresolved({0.2, 1, 0}, wash("1 Pa s")),
              HasSubstr("(below 15 % is good, white noise has 37.5 %). Torque, stress and motion "
                        "of such a run mean little; try more domain.cells or a larger "
                        "fluid.viscosity."));
  EXPECT_THAT(*unresolved({0.1, 9, 2.7}, wash("1 Pa s")), HasSubstr("3.3 times the 2.7 m/s"));
}

TEST(Resolution, TheWorstOfSeveral) {
  Resolution worst;
  worst.take_worst({0.1, 2, 2.7});
  worst.take_worst({0.05, 3, 2.7});
  EXPECT_EQ(worst.grid_scale, 0.1);
  EXPECT_EQ(worst.speed, 3);
  EXPECT_DOUBLE_EQ(worst.speed_ratio(), 3 / 2.7);
}

/// By the Reynolds number of a cell and the thickness of layers, not by Re alone: a finer grid or a
/// slower flow is not warned of.
TEST(Resolution, IsForeseen) {
  EXPECT_FALSE(foresee_unresolved(wash("1 Pa s")));
  EXPECT_FALSE(foresee_unresolved(wash("0.1 Pa s", "64")));
  EXPECT_TRUE(foresee_unresolved(wash("0.1 Pa s")));
  EXPECT_EQ(
      foresee_unresolved(wash("1e-3 Pa s")).value_or(""),
      "the grid will hardly resolve this flow: at 3.9 m/s the Reynolds number of a cell is "
      "8.7e+04 (up to about 500 is good), and layers along surfaces are about 0.28 mm thick "
      "in cells of 22.3 mm. Expect velocities that alternate from cell to cell, water several "
      "times faster than what drives it, and kinetic energy that grows from cycle to cycle; "
      "try a fluid.viscosity of 0.17 Pa s or more on this grid, or 1.7e+02 times as many "
      "domain.cells along every axis");
  Case stream;
  stream.dimension = 2;
  stream.domain.size = {1, 1, 0};
  stream.domain.cells = {10, 10, 1};
  stream.domain.sides[0] = {SideKind::inflow, {1, 0, 0}};
  stream.fluid = {.density = 1, .viscosity = 1e-3};
  EXPECT_FALSE(foresee_unresolved(stream));
  stream.fluid.viscosity = 1e-4;
  EXPECT_THAT(foresee_unresolved(stream).value_or(""),
              HasSubstr("at 1 m/s the Reynolds number of a cell is 1e+03 (up to about 500 is "
                        "good). Expect"));
}

/// Water as thin as it really is on a coarse grid turns into noise within a stroke; a thousand
/// times as thick it does not.
TEST(VerificationResolution, TellsRealWaterOnACoarseGrid) {
  const auto worst = [](const std::string& viscosity) {
    const Case whole = read_case(
        "cases/wash-3d/case.toml",
        {"domain.cells=16", "cloth.count=1", "cloth.nodes=[4, 4]", "fluid.viscosity=" + viscosity});
    Simulation<3> simulation(whole, Parallel());
    const double fastest = driving_speed<3>(simulation.grid(), simulation.mapping(), {}, 0);
    EXPECT_NEAR(fastest, 2.7, 0.6);  // the tip of a fin, within a cell
    Resolution found;
    while (simulation.time() < 0.5) {
      simulation.step(0.5);
      found.take_worst(find_resolution(simulation.flow(), fastest, simulation.last().speed));
    }
    return found;
  };
  EXPECT_FALSE(worst("1e-3 Pa s").resolved());
  EXPECT_TRUE(worst("2 Pa s").resolved());
}

}  // namespace
}  // namespace washtub
