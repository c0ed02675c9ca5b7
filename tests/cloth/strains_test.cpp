#include "cloth/strains.hpp"

#include <gtest/gtest.h>

#include "base/snapshot.hpp"
#include "cloth/stress.hpp"
#include "sheets.hpp"

namespace washtub {
namespace {

/// A plate of 1 % more length along r and 2 % less along s, sheared.
std::vector<Vec<3>> deformed(const Sheet<3>& sheet, double shear) {
  auto X = testing::flat(sheet);
  for (auto& x : X) x = {1.01 * x[0] + shear * x[1], 0.98 * x[1], 0};
  return X;
}

Sheet<3> plate() { return make_plate({6, 5}, {0.01, 0.02}, {8e3, 300, 1e-4, 2e-4, 0, 0, 1e-3}); }

TEST(Strains, HaveTheirSigns) {
  const auto sheet = plate();
  for (const double shear : {0.05, -0.05}) {
    Strains strains;
    find_strains<3>(sheet, deformed(sheet, shear), strains);
    ASSERT_EQ(strains.along[0].size(), 25u);
    ASSERT_EQ(strains.along[1].size(), 24u);
    ASSERT_EQ(strains.shear.size(), 20u);
    const double s2 = shear * shear + 0.98 * 0.98;
    for (const double e : strains.along[0]) EXPECT_NEAR(e, 0.5 * (1 - 1 / (1.01 * 1.01)), 1e-12);
    for (const double e : strains.along[1]) EXPECT_NEAR(e, 0.5 * (1 - 1 / s2), 1e-12);
    for (const double e : strains.shear) EXPECT_NEAR(e, 0.5 * shear / std::sqrt(s2), 1e-12);
  }
}

TEST(Strains, TellTensionFromCompression) {
  const auto sheet = plate();
  const auto X = deformed(sheet, 0);
  Strains strains;
  find_strains<3>(sheet, X, strains);
  std::vector<NodeStress> out(X.size());
  find_stress(sheet, X, strains, out);
  const double scale = 0.5 * 8e3 / 1e-3;  // half of the edges each
  for (const auto& o : out) {
    EXPECT_NEAR(o.tension, scale * strains.along[0][0], 1e-9 * scale);
    EXPECT_NEAR(o.compression, -scale * strains.along[1][0], 1e-9 * scale);
  }
}

/// A step of strain comes through as 1 - exp(-t/T), whatever the time step, and strain that
/// alternates does not come through at all.
TEST(SteadyStrains, AreLowPassed) {
  constexpr double T = 8e-3, end = 16e-3;
  const auto sheet = plate();
  const auto flat = testing::flat(sheet), stretched = deformed(sheet, 0.05);
  Strains whole;
  find_strains<3>(sheet, stretched, whole);
  for (const int steps : {4, 40}) {
    Cloth<3> cloth;
    cloth.add(sheet, flat);
    SteadyStrains<3> steady(cloth, T);
    cloth.position = stretched;
    for (int i = 0; i < steps; ++i) steady.add(cloth, end / steps);
    const double share = 1 - std::exp(-end / T);
    EXPECT_NEAR(steady.of_piece(0).along[0][7], share * whole.along[0][7], 1e-12);
    EXPECT_NEAR(steady.of_piece(0).shear[7], share * whole.shear[7], 1e-12);
  }
  Cloth<3> cloth;
  cloth.add(sheet, flat);
  SteadyStrains<3> steady(cloth, T), none(cloth, 0);
  for (int i = 0; i < 400; ++i) {
    cloth.position = deformed(sheet, i % 2 == 0 ? 0.05 : -0.05);
    steady.add(cloth, 0.1e-3);
    none.add(cloth, 0.1e-3);
  }
  EXPECT_LT(std::abs(steady.of_piece(0).shear[7]), 0.02 * whole.shear[7]);
  EXPECT_NEAR(none.of_piece(0).shear[7], -whole.shear[7], 1e-12);
}

TEST(SteadyStrains, AreState) {
  const auto sheet = plate();
  Cloth<3> cloth;
  cloth.add(sheet, testing::flat(sheet));
  SteadyStrains<3> one(cloth, 8e-3), other(cloth, 8e-3);
  cloth.position = deformed(sheet, 0.05);
  one.add(cloth, 4e-3);
  Snapshot snapshot;
  snapshot.take(one);
  snapshot.put_back(other);
  EXPECT_EQ(one.of_piece(0).along, other.of_piece(0).along);
  EXPECT_EQ(one.of_piece(0).shear, other.of_piece(0).shear);
  EXPECT_GT(one.of_piece(0).shear[3], 0.001);
}

}  // namespace
}  // namespace washtub
