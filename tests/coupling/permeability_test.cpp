#include "coupling/permeability.hpp"

#include <gtest/gtest.h>

#include "cloth/plate.hpp"
#include "cloth/weight.hpp"
#include "coupling/pool.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double lambda = 2e-4, dt = 1e-3;

/// A thread across the whole periodic unit square, at rest without tension.
Cloth<2> across(bool upright, double excess, const std::vector<int>& pinned) {
  constexpr int n = 24;
  const Vec<2> along = upright ? Vec<2>::UnitY() : Vec<2>::UnitX();
  std::vector<Vec<2>> where;
  for (int i = 0; i < n; ++i)
    where.push_back(i * along / n + 0.51 * (upright ? Vec<2>::UnitX() : Vec<2>::UnitY()));
  Material material{2e3, 0, 1e-3, 0, 0, excess, 1e-3};
  material.permeability = lambda;
  Cloth<2> cloth;
  cloth.add(make_thread(n, 1.0 / n, material, true, along), where, pinned);
  return cloth;
}

class Permeable : public ::testing::TestWithParam<Scheme> {};
INSTANTIATE_TEST_SUITE_P(Cloth, Permeable,
                         ::testing::Values(Scheme::implicit, Scheme::explicit_euler,
                                           Scheme::broyden));

}  // namespace

/// Held across a duct that is closed to a ring, it brakes the water by [p] = U/lambda, so that
/// density dU/dt = -U/(lambda L).
TEST_P(Permeable, HeldAcrossADuctTakesDarcysPressure) {
  std::vector<int> all(24);
  for (int i = 0; i < 24; ++i) all[static_cast<std::size_t>(i)] = i;
  Pool<2> pool(square(), 1, across(true, 0, all), GetParam());
  pool.water.start_from([](int d, const Vec<2>&) { return d == 0 ? 0.1 : 0.0; });
  const double time = 1000 * lambda;  // in which U falls to 1/e
  for (int i = 1; i <= 300; ++i) {
    pool.step(dt, 1e-8);
    const double before = pool.momentum()[0], U = before / 1000;
    EXPECT_NEAR(U, 0.1 * std::exp(-i * dt / time), 2e-3 * 0.1) << i;
    if (i < 5) continue;  // the force grows to it
    EXPECT_NEAR(pool.force()[0], -before / (1000 * lambda), 0.02 * before / (1000 * lambda)) << i;
  }
}

/// Falling across the whole box, it goes through the water with lambda times its weight per area.
TEST_P(Permeable, FallsThroughTheWaterByItsWeight) {
  constexpr double excess = 0.5, g = 10;
  Pool<2> pool(square(), 1, across(false, excess, {}), GetParam());
  pool.coupling.add(std::make_unique<Weight<2>>(pool.cloth, Vec<2>{0, -g}));
  for (int i = 0; i < 50; ++i) pool.step(dt, 1e-8);
  double speed = 0;
  for (const auto& v : pool.cloth.velocity) speed += v[1] / 24;
  const double water = -excess * g * 50 * dt / 1000;  // which takes up the weight
  EXPECT_NEAR(speed - water, -lambda * excess * g, 0.02 * lambda * excess * g);
}

/// Along its normal alone, which turns with it.
TEST(Permeable, IsAcrossTheCloth) {
  Material material{2e3, 100, 1e-2, 1e-2, 0, 0, 1e-3};
  material.permeability = lambda;
  const auto sheet = make_plate({5, 5}, {0.1, 0.1}, material);
  const Vec<3> r = Vec<3>(2, 1, 0.5).normalized(), s = Vec<3>(-0.25, 0, 1).normalized();
  std::vector<Vec<3>> where;
  for (int n = 0; n < 25; ++n) where.push_back(0.1 * (n % 5) * r + 0.1 * (n / 5) * s);
  Cloth<3> cloth;
  cloth.add(sheet, where);
  const ClothSurface<3> surface(cloth);
  Permeability<3> through(cloth, surface);
  ASSERT_TRUE(through.any());
  through.find(cloth.position);
  const Vec<3> n = r.cross(s);
  for (std::size_t i = 0; i < 25; ++i) {
    EXPECT_LT((through[i] * r).norm(), 1e-12 * lambda / sheet.area[i]);
    EXPECT_NEAR(n.dot(through[i] * n), lambda / sheet.area[i], 1e-9 * lambda / sheet.area[i]);
  }
  cloth.groups[0].sheet.material.permeability = 0;
  EXPECT_FALSE(Permeability<3>(cloth, surface).any());
}

/// Stiff cloth with nets that buckle stays stable at the step of the flow however open it is.
TEST(Permeable, LetsTheImplicitSchemeCarryStiffCloth) {
  for (const double open : {1e-5, 1e-4, 1e-3}) {
    Material material{8e4, 3e2, 1e-5, 1e-5, 0, 0.1, 2.4e-4};
    material.permeability = open;
    std::vector<Vec<3>> where;
    for (int n = 0; n < 25; ++n)
      where.emplace_back(0.3 + 0.1 * (n % 5), 0.3 + 0.098 * (n / 5), 0.45 + 0.01 * (n % 2));
    Cloth<3> cloth;
    cloth.add(make_plate({5, 5}, {0.1, 0.1}, material), where);
    Pool<3> pool(cubic_mesh<3>({0, 0, 0}, 1, 16, true), 1, cloth, Scheme::implicit);
    pool.water.start_from(
        [](int d, const Vec<3>& x) { return d == 2 ? 0.5 * std::sin(2 * M_PI * x[0]) : 0.0; });
    double strain = 0;
    for (int i = 0; i < 200; ++i) strain = pool.step(2e-3).largest_strain;
    EXPECT_LT(strain, 0.05) << open;
  }
}
