#include "cloth/energy.hpp"

#include <gtest/gtest.h>

#include "sheets.hpp"

namespace washtub {
namespace {

/// Two plates, one of them stretched, that fall together: elastic energy of the one, and kinetic
/// energy of the mass of both beyond that of the water.
TEST(ClothEnergy, HasItsTwoParts) {
  Material material{50, 20, 0.3, 0.2, 0, 2, 1e-3};
  const auto sheet = make_plate({5, 4}, {0.1, 0.13}, material);
  std::vector<Vec<3>> X = testing::flat(sheet);
  for (std::size_t i = 0; i < 20; ++i) X.push_back(1.05 * X[i]);
  Cloth<3> cloth;
  cloth.add(sheet, X);
  const double elastic = sheet.energy(cloth.piece(cloth.groups[0], 1));
  EXPECT_GT(elastic, 0);
  EXPECT_NEAR(energy(cloth), elastic, 1e-14);
  for (auto& v : cloth.velocity) v = Vec<3>(0, 3, -4);
  const double mass = 2 * 2 * (4 * 0.1) * (3 * 0.13);
  EXPECT_NEAR(energy(cloth), elastic + 0.5 * mass * 25, 1e-12);
}

}  // namespace
}  // namespace washtub
