#include "solid/mapping.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/wash_tub.hpp"

namespace washtub {
namespace {

/// A turning disc so large that its reach covers the sides of the box: the box stays closed.
TEST(Mapping, SidesOfTheBoxDoNotTurnWithASolid) {
  const auto mesh = testing::cubic_mesh<2>(Vec<2>::Constant(-0.5), 1, 32);
  const Grid<2> grid(mesh, Parallel(), granularity(mesh));
  DomainMapping<2> mapping(grid,
                           {{"disc", cylinder(0.45, -1, 1), Vec<3>::Zero(), constant_speed(3)}});
  std::array<Field, 2> u = {grid.make_field(), grid.make_field()};
  mapping.update(0.1);
  mapping.impose(u);
  const auto& block = grid.block();
  for (int k = 0; k < block.planes(); ++k) EXPECT_EQ(u[0][block.at({0, k})], 0);
  if (!grid.at_side(1, 0)) return;
  for (int i = 0; i < block.width(); ++i) EXPECT_EQ(u[1][block.at({i, 0})], 0);
}

/// Faces along x that a half space with the outward normal (cos a, sin a) closes when shifted.
int closed_by_half_space(double angle, double distance, double shift) {
  const auto mesh = testing::cubic_mesh<2>(Vec<2>::Constant(-0.5), 1, 32);
  const Grid<2> grid(mesh, Parallel(), granularity(mesh));
  const Vec<3> normal(std::cos(angle), std::sin(angle), 0);
  const DomainMapping<2> mapping(
      grid, {{"wall", half_space(distance * normal, normal), Vec<3>::Zero(), at_rest()}},
      Heaviside::sharp(shift));
  int closed = 0;
  const auto& block = grid.block();
  for (int k = 0; k < block.planes(); ++k)
    for (int i = 0; i < block.width(); ++i) closed += mapping.open()[0][block.at({i, k})] == 0;
  return closed;
}

/// A shift closes what a wall further out by so many cell widths along its normal would close.
TEST(Mapping, ShiftMovesTheSurfaceOutByCellWidths) {
  const double h = 1.0 / 32;
  for (const double angle : {0.0, 0.4, 0.785, 2.0}) {
    const double out = 0.3 * h * (std::abs(std::cos(angle)) + std::abs(std::sin(angle)));
    EXPECT_EQ(closed_by_half_space(angle, 0.101, 0.3), closed_by_half_space(angle, 0.101 + out, 0));
  }
  EXPECT_GT(closed_by_half_space(0.4, 0.101, 0.3), closed_by_half_space(0.4, 0.101, 0));
}

/// Faces that are looked at only when they can have changed are the same as all looked at anew.
void expect_followed_as_fresh(const Heaviside& heaviside) {
  const auto mesh = testing::wash_mesh(24);
  const Grid<3> grid(mesh, Parallel(), granularity(mesh));
  DomainMapping<3> followed(grid, testing::wash_solids(true), heaviside);
  int flips = 0;
  for (int step = 1; step <= 300; ++step) flips += followed.update(1e-3 * step).any;
  EXPECT_GT(flips, 100);
  auto solids = testing::wash_solids(true);
  solids[1].shape = rotate_z(solids[1].shape, solids[1].drive.angle(0.3));
  const DomainMapping<3> fresh(grid, solids, heaviside);
  int differ = 0;
  for (int d = 0; d < 3; ++d)
    for (int k = 0; k < grid.block().planes(); ++k)
      for (int j = 0; j < grid.block().rows(); ++j)
        for (int i = 0; i < grid.block().width(); ++i) {
          const long p = grid.block().at({i, j, k});
          differ += std::abs(followed.open()[d][p] - fresh.open()[d][p]) > 1e-6;
        }
  EXPECT_EQ(differ, 0);
}
TEST(Mapping, SkippedFacesAreTheSameAsFreshOnes) { expect_followed_as_fresh(Heaviside::sharp()); }
TEST(Mapping, SkippedFacesAreTheSameAsFreshOnesWhenShifted) {
  expect_followed_as_fresh(Heaviside::sharp(0.2));
}
TEST(Mapping, SkippedFacesAreTheSameAsFreshOnesWhenSmooth) {
  expect_followed_as_fresh(Heaviside::smooth(0.02));
}
TEST(Mapping, SkippedFacesAreTheSameAsFreshOnesWhenGradual) {
  expect_followed_as_fresh(Heaviside::gradual());
}

/// The lists of faces in solids have each of them once, also after faces have opened and closed:
/// all of the solid that turns, of the others at least those at the water.
void expect_whole_surface(const Heaviside& heaviside) {
  const auto mesh = testing::wash_mesh(24);
  const Grid<3> grid(mesh, Parallel(), granularity(mesh));
  DomainMapping<3> mapping(grid, testing::wash_solids(true), heaviside);
  for (int step = 1; step <= 100; ++step) mapping.update(3e-3 * step);
  const auto& block = grid.block();
  for (int d = 0; d < 3; ++d) {
    const float* open = mapping.open()[d];
    std::vector<int> listed(static_cast<std::size_t>(block.size));
    for (int solid = 0; solid < 2; ++solid)
      mapping.for_surface(solid, d, [&](const SurfaceFace<3>& face) {
        EXPECT_EQ(mapping.owner(d)[face.p], solid);
        EXPECT_EQ(++listed[static_cast<std::size_t>(face.p)], 1);
        EXPECT_LT(open[face.p], 1);
      });
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (int i = 0; i < block.width(); ++i) {
          const long p = block.at({i, j, k});
          bool at_water = false;
          for (const long s : block.stride) at_water |= open[p - s] >= 1 || open[p + s] >= 1;
          const int owner = mapping.owner(d)[p];
          if (open[p] < 1 && (owner == 1 || (owner == 0 && at_water))) {
            EXPECT_EQ(listed[static_cast<std::size_t>(p)], 1)
                << d << ": " << i << " " << j << " " << k;
          }
        }
  }
}

TEST(Mapping, ListsItsSurface) { expect_whole_surface(Heaviside::sharp()); }
TEST(Mapping, ListsItsSurfaceWhenSmooth) { expect_whole_surface(Heaviside::smooth(0.02)); }
TEST(Mapping, ListsItsSurfaceWhenGradual) { expect_whole_surface(Heaviside::gradual()); }

}  // namespace
}  // namespace washtub
