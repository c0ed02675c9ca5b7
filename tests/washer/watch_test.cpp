#include "washer/watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "cloth/sheets.hpp"
#include "support/water_box.hpp"

namespace washtub {
namespace {

using testing::cubic_mesh;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using testing::WaterBox;

template <int D>
testing::WaterSetup<D> still_water() {
  testing::WaterSetup<D> setup;
  setup.mesh = cubic_mesh<D>(Vec<D>::Zero(), 1, 16);
  return setup;
}

/// A box of still water with two plates at rest, and a healthy step.
struct Tank {
  WaterBox<3> water{still_water<3>()};
  Cloth<3> cloth;
  Case whole;
  StepHealth step{.number = 8123,
                  .time = 0.412,
                  .dt = 1e-3,
                  .courant = 0.2,
                  .divergence = 1e-5,
                  .cycles = 4,
                  .speed = 2,
                  .kinetic = 5,
                  .strain = 0.01,
                  .slip = 0.01,
                  .driving_speed = 2.7};

  Tank() {
    const auto sheet = testing::plate(0);
    auto X = testing::flat(sheet);
    const auto second = X;
    X.insert(X.end(), second.begin(), second.end());
    cloth.add(sheet, X);
  }
  /// "" where nothing is wrong.
  std::string look() const {
    const auto trouble = find_trouble(step, water.flow, cloth, whole);
    return trouble ? trouble->text : "";
  }
};

TEST(Watch, FindsNothingWrongWithAHealthyStep) { EXPECT_EQ(Tank().look(), ""); }

TEST(Watch, NamesWhatIsNoNumber) {
  Tank tank;
  tank.step.slip = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(tank.look(),
            "step 8123, t = 0.412 s: the state is no longer a finite number; try a smaller "
            "time.step or time.cfl");
  if (tank.water.grid.parallel().rank() == tank.water.grid.parallel().size() - 1)
    tank.water.flow.velocity()[1][tank.water.grid.block().at({3, 2, 1})] =
        std::numeric_limits<double>::infinity();
  EXPECT_THAT(tank.look(), HasSubstr(": the velocity, at (0.219, 0."));
  tank.cloth.position[27][2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(tank.look(), HasSubstr(": the cloth, at node (2, 1) of piece 2 is no longer"));
}

TEST(Watch, NamesThePressureSolve) {
  Tank tank;
  tank.step.converged = false;
  tank.step.cycles = 60;
  EXPECT_EQ(tank.look(), "");  // a solve that came close enough
  tank.step.divergence = 0.2;
  EXPECT_EQ(tank.look(),
            "step 8123, t = 0.412 s: the pressure solve left |div u| h/U = 0.2 after 60 cycles; "
            "try a larger solver.max_cycles");
}

TEST(Watch, NamesAStepThatIsTooLong) {
  Tank tank;
  tank.step.courant = 1.5;
  EXPECT_EQ(tank.look(), "");  // the next step will be shorter
  tank.whole.time.fixed = true;
  EXPECT_THAT(tank.look(), HasSubstr("the water goes 1.5 cells in a step of 0.001 s, limit 1; try "
                                     "a time.step of 0.0002 s, or time.fixed = false"));
}

/// Where an edge is strained when the step is over, not only on the way there.
TEST(Watch, NamesClothThatIsStrained) {
  Tank tank;
  tank.step.strain = 0.4;
  EXPECT_EQ(tank.look(), "");
  tank.cloth.position[20 + 9][0] += 0.03;  // node (4, 1) of the second piece
  EXPECT_THAT(tank.look(),
              StartsWith("step 8123, t = 0.412 s: piece 2 of the cloth is stretched by "
                         "30 % at node (3, 1)"));
}

TEST(Watch, NamesSlip) {
  Tank tank;
  tank.step.slip = 2.7;
  EXPECT_THAT(tank.look(), HasSubstr("slips through the water at 2.7 m/s (rms over its nodes), 100 "
                                     "% of the 2.7 m/s of what drives it, limit 50 %; try a "
                                     "smaller time.step or time.cfl"));
  tank.step.driving_speed = 0;  // nothing to compare with
  EXPECT_EQ(tank.look(), "");
}

TEST(Watch, NamesWaterThatIsTooFast) {
  Tank tank;
  tank.step.speed = 54;
  tank.water.start_from([](int d, const Vec<3>& x) {
    return d == 2 && (x - Vec<3>(0.28125, 0.71875, 0.5)).norm() < 1e-6 ? -54 : 0.0;
  });
  EXPECT_THAT(tank.look(), HasSubstr("the water reaches 54 m/s at (0.281, 0.719, 0.5) m, 20 times "
                                     "the 2.7 m/s of what drives it, limit 10: the grid does not "
                                     "resolve this flow; try more domain.cells or a larger "
                                     "fluid.viscosity"));
  tank.step.driving_speed = 0;
  EXPECT_EQ(tank.look(), "");
}

/// In two dimensions nodes have one number.
TEST(Watch, NamesNodesOfThreads) {
  WaterBox<2> water(still_water<2>());
  Cloth<2> cloth;
  const auto sheet = testing::thread();
  cloth.add(sheet, testing::flat(sheet));
  cloth.position[8][0] = std::numeric_limits<double>::quiet_NaN();
  const double none = cloth.position[8][0];
  const auto trouble = find_trouble<2>({.number = 1, .slip = none}, water.flow, cloth, Case());
  ASSERT_TRUE(trouble);
  EXPECT_EQ(trouble->kind, TroubleKind::not_finite);
  EXPECT_THAT(trouble->text, HasSubstr("the cloth, at node 8 of piece 1 is no longer"));
}

}  // namespace
}  // namespace washtub
