#include "solid/mapping.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/wash_tub.hpp"

namespace washtub {
namespace {

/// A turning disc so large that its reach covers the sides of the box: the box stays closed.
TEST(Mapping, SidesOfTheBoxDoNotTurnWithASolid) {
  const auto mesh = testing::cubic_mesh<2>(Vec<2>::Constant(-0.5), 1, 32);
  const Grid<2> grid(mesh, Parallel(), granularity(mesh));
  DomainMapping<2> mapping(grid,
                           {{"disc", cylinder(0.45, -1, 1), Vec<3>::Zero(), constant_speed(3)}}, 0);
  std::array<Field, 2> u = {grid.make_field(), grid.make_field()};
  mapping.update(0.1);
  mapping.impose(u);
  const auto& block = grid.block();
  for (int k = 0; k < block.planes(); ++k) EXPECT_EQ(u[0][block.at({0, k})], 0);
  if (!grid.at_side(1, 0)) return;
  for (int i = 0; i < block.width(); ++i) EXPECT_EQ(u[1][block.at({i, 0})], 0);
}

/// Faces that are looked at only when they can have changed are the same as all looked at anew.
TEST(Mapping, SkippedFacesAreTheSameAsFreshOnes) {
  const auto mesh = testing::wash_mesh(24);
  const Grid<3> grid(mesh, Parallel(), granularity(mesh));
  DomainMapping<3> followed(grid, testing::wash_solids(true), 0);
  int flips = 0;
  for (int step = 1; step <= 300; ++step) flips += followed.update(1e-3 * step).flipped;
  EXPECT_GT(flips, 100);
  auto solids = testing::wash_solids(true);
  solids[1].shape = rotate_z(solids[1].shape, solids[1].drive.angle(0.3));
  const DomainMapping<3> fresh(grid, solids, 0);
  int differ = 0;
  for (int d = 0; d < 3; ++d)
    for (int k = 0; k < grid.block().planes(); ++k)
      for (int j = 0; j < grid.block().rows(); ++j)
        for (int i = 0; i < grid.block().width(); ++i) {
          const long p = grid.block().at({i, j, k});
          differ += followed.open()[d][p] != fresh.open()[d][p];
        }
  EXPECT_EQ(differ, 0);
}

}  // namespace
}  // namespace washtub
