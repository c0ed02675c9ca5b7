#include "report/fields.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "report/thinning.hpp"

namespace washtub {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::FloatNear;

/// A plane lattice of 4 x 2 cells whose u is the cell's number, with some cells in a solid.
Lattice plane(const std::vector<float>& solid) {
  Lattice water{{4, 2, 1}, 2, {0, 1, 2, 3, 4, 5, 6, 7}, {}, solid};
  water.velocity.insert(water.velocity.end(), 8, 1.F);
  return water;
}

TEST(Coarsen, IsTheMeanOfTheOpenCells) {
  const Lattice coarse = coarsen(plane({0, 1, 0, 0, 1, 1, 0, 0.5}));
  EXPECT_EQ(coarse.cells, (std::array{2, 1, 1}));
  EXPECT_THAT(coarse.solid, ElementsAre(0.75, 0.125));
  EXPECT_NEAR(coarse.velocity[0], 0, 1e-4);
  EXPECT_NEAR(coarse.velocity[1], (2 + 3 + 6 + 0.5 * 7) / 3.5, 1e-4);
  EXPECT_NEAR(coarse.velocity[2], 1, 1e-6);
}

/// A field that only its declaration knows is averaged like the velocity.
TEST(Coarsen, TakesEveryScalarAlong) {
  Lattice fine = plane({0, 1, 0, 0, 1, 1, 0, 0.5});
  fine.scalars = {{{"salt", "salt", "kg/m^3", 1, ""}, {0, 1, 2, 3, 4, 5, 6, 7}}};
  const Lattice coarse = coarsen(fine);
  ASSERT_EQ(coarse.scalars.size(), 1U);
  EXPECT_EQ(coarse.scalars[0].field.name, "salt");
  EXPECT_NEAR(coarse.scalars[0].values[1], (2 + 3 + 6 + 0.5 * 7) / 3.5, 1e-4);
}

TEST(Lattice, HasEveryScalarOfTheFrames) {
  const FieldDescription salt{"salt", "salt", "kg/m^3", 1, ""};
  const WaterFrame water{{2, 1, 1},
                         {{salt, {7, 8}},
                          {{"solid", "solid fraction", "", 1, ""}, {0, 1}},
                          {{"velocity", "velocity", "m/s", 3, ""}, {1, 2, 3, 4, 5, 6}}}};
  const Lattice all = lattice(water, 3, Vec<3>::Ones(), {});
  ASSERT_EQ(all.scalars.size(), 1U);
  EXPECT_EQ(all.scalars[0].field, salt);
  EXPECT_THAT(all.velocity, ElementsAre(1, 4, 2, 5, 3, 6));
}

TEST(Coarsen, InSolidsIsThePlainMean) {
  const Lattice coarse = coarsen(plane({1, 1, 1, 1, 1, 1, 1, 1}));
  EXPECT_NEAR(coarse.velocity[0], 2.5, 1e-5);
  EXPECT_THAT(coarse.solid, Each(1));
}

TEST(Coarsen, KeepsAUniformStreamOnOddCells) {
  Lattice water{{5, 3, 7}, 3, std::vector<float>(3 * 105, 2.F), {}, std::vector<float>(105, 0.F)};
  const Lattice coarse = coarsen(coarsen(water));
  EXPECT_EQ(coarse.cells, (std::array{2, 1, 2}));
  EXPECT_EQ(coarse.cells, coarse_cells(water.cells, 2));
  EXPECT_THAT(coarse.velocity, Each(FloatNear(2, 1e-6F)));
}

TEST(Vorticity, OfRigidRotationIsTwiceItsSpeed) {
  const std::array<int, 3> cells = {6, 5, 1};
  const Vec<3> h(0.1, 0.2, 1);
  std::vector<float> velocity(60);
  for (std::size_t n = 0; n < 30; ++n) {
    velocity[n] = static_cast<float>(-3 * h.y() * static_cast<double>(n / 6));
    velocity[30 + n] = static_cast<float>(3 * h.x() * static_cast<double>(n % 6));
  }
  EXPECT_THAT(vorticity(velocity, cells, h, {false, false}), Each(FloatNear(6, 1e-4F)));
}

TEST(Vorticity, GoesOnThroughPeriodicSides) {
  const int n = 64;
  const double h = 2 * M_PI / n;
  std::vector<float> velocity(2 * n, 0.F);
  for (int i = 0; i < n; ++i) velocity[static_cast<std::size_t>(n + i)] = std::sin(float(i * h));
  const auto w = vorticity(velocity, {n, 1, 1}, Vec<3>::Constant(h), {true, false});
  for (int i = 0; i < n; ++i) EXPECT_NEAR(w[static_cast<std::size_t>(i)], std::cos(i * h), 2e-3);
}

TEST(Thinning, GoesFromEverythingToNoFrame) {
  const auto plans = thinnings({20, {64, 64, 1}, 0, 0});
  std::vector<std::array<int, 3>> found;
  for (const Thinning& p : plans) found.push_back({p.coarsenings, p.water_every, p.frames_every});
  EXPECT_THAT(found, ElementsAre(std::array{0, 1, 1}, std::array{1, 1, 1}, std::array{2, 1, 1},
                                 std::array{2, 2, 1}, std::array{2, 4, 1}, std::array{2, 8, 1},
                                 std::array{0, 0, 1}, std::array{0, 0, 2}, std::array{0, 0, 4},
                                 std::array{0, 0, 8}, std::array{0, 0, 16}, std::array{0, 0, 32},
                                 std::array{0, 0, 0}));
  EXPECT_EQ(thinnings({20, {24, 40, 40}, 0, 0})[1].coarsenings, 0) << "12 cells are too few";
  EXPECT_EQ(thinnings({}).size(), 1U);
}

TEST(Thinning, TakesTheTracksBeforeTheHistory) {
  std::vector<std::array<int, 2>> found;
  for (const Thinning& p : thinnings({0, {0, 0, 0}, 900, 450}))
    found.push_back({p.tracks_every, p.history_every});
  EXPECT_THAT(found, ElementsAre(std::array{1, 1}, std::array{2, 1}, std::array{4, 1},
                                 std::array{8, 1}, std::array{8, 2}, std::array{8, 4}));
}

TEST(Thinning, KeepsTheFirstAndTheLast) {
  EXPECT_THAT(kept(6, 2), ElementsAre(0, 2, 4, 5));
  EXPECT_THAT(kept(5, 2), ElementsAre(0, 2, 4));
  EXPECT_THAT(kept(3, 8), ElementsAre(0, 2));
  EXPECT_THAT(kept(1, 8), ElementsAre(0));
  EXPECT_TRUE(kept(0, 1).empty() && kept(9, 0).empty());
  EXPECT_EQ(thin_rows("t\n0\n1\n2\n3\n", 2), "t\n0\n2\n3\n");
  EXPECT_EQ(thin_rows("t\n", 4), "t\n");
}

TEST(Thinning, SaysWhatIsLeftOut) {
  EXPECT_THAT(thinning_notes({}, {129, {64, 64, 64}, 9, 9}), ElementsAre());
  EXPECT_THAT(thinning_notes({1, 4, 1, 1, 1}, {129, {64, 64, 32}, 0, 0}),
              ElementsAre("33 of 129 frames carry the water.",
                          "The water is shown on 32 x 32 x 16 of 64 x 64 x 32 cells."));
  EXPECT_THAT(
      thinning_notes({0, 0, 4, 8, 2}, {513, {64, 64, 1}, 9, 9}),
      ElementsAre("Curves: 1 of 2 rows is kept.", "Curves of the pieces: 1 of 8 rows is kept.",
                  "129 of 513 frames are shown.", "The water is left out to keep the page small."));
}

}  // namespace
}  // namespace washtub
