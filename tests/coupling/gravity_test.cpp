#include <gtest/gtest.h>

#include "cloth/weight.hpp"
#include "coupling/pool.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double g = 9.81, length = 0.4;

/// A thread of 0.4 m that hangs straight from its first node, if that is pinned.
Cloth<2> hanging(double excess, const std::vector<int>& pinned) {
  std::vector<Vec<2>> where;
  for (int i = 0; i < 9; ++i) where.emplace_back(0.5, 0.8 - 0.05 * i);
  Cloth<2> cloth;
  cloth.add(make_thread(9, 0.05, {2e3, 0, 1e-3, 0, 0, excess, 1e-3}), where, pinned);
  return cloth;
}

class WeightOfCloth : public ::testing::TestWithParam<Scheme> {};
INSTANTIATE_TEST_SUITE_P(Coupling, WeightOfCloth,
                         ::testing::Values(Scheme::implicit, Scheme::explicit_euler,
                                           Scheme::broyden));

}  // namespace

TEST(HeavyCloth, FallsWithTheWaterItDrags) {
  constexpr double excess = 50;  // kg/m^2; the water that a node drags along has some 60
  for (const Scheme scheme : {Scheme::implicit, Scheme::broyden}) {
    Pool<2> pool(square(), 1, hanging(excess, {}), scheme);
    pool.coupling.add(std::make_unique<Weight<2>>(pool.cloth, Vec<2>{0, -g}));
    for (int i = 1; i <= 20; ++i) {
      pool.step(1e-3, 1e-8);
      EXPECT_NEAR(pool.momentum()[1], -excess * length * g * 1e-3 * i, 1e-6 * i);
    }
    const double free_fall = 20e-3 * g;
    EXPECT_LT(pool.cloth.velocity[4][1], -0.1 * free_fall);
    EXPECT_GT(pool.cloth.velocity[4][1], -0.9 * free_fall);
  }
}

TEST_P(WeightOfCloth, OfLightClothGoesToTheWater) {
  constexpr double excess = 2;
  Pool<2> pool(square(), 1, hanging(excess, {}), GetParam());
  pool.coupling.add(std::make_unique<Weight<2>>(pool.cloth, Vec<2>{0, -g}));
  for (int i = 0; i < 40; ++i) pool.step(1e-3, 1e-8);
  EXPECT_NEAR(pool.momentum()[1], -excess * length * g * 40e-3, 2e-3 * excess * length * g * 40e-3);
}

TEST_P(WeightOfCloth, HangsOnThePins) {
  constexpr double excess = 2;
  Pool<2> pool(square(), 200, hanging(excess, {0}), GetParam());
  pool.coupling.add(std::make_unique<Weight<2>>(pool.cloth, Vec<2>{0, -g}));
  for (int i = 0; i < 1000; ++i) pool.step(2e-3);
  const double weight = excess * (length - 0.025) * g;  // of the nodes below the pin
  EXPECT_NEAR(pool.cloth.elastic[0][1], -weight, 0.01 * weight);
  EXPECT_LT(pool.force().norm(), 0.01 * weight);
}
