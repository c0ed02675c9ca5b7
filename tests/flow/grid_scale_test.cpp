#include "flow/grid_scale.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "flow/annulus.hpp"

namespace washtub {
namespace {

using testing::annulus;
using testing::cubic_mesh;
using testing::WaterBox;

/// A periodic box of 16 cubes along every axis, in cells.
template <int D>
WaterBox<D> periodic_box() {
  return WaterBox<D>({.mesh = cubic_mesh<D>(Vec<D>::Zero(), 16, 16, true)});
}

template <int D>
Vec<D> share(const WaterBox<D>& box) {
  return grid_scale_energy<D>(box.grid, box.flow.velocity(), box.mapping.open());
}

/// A number that belongs to a face, whichever rank has it.
double noise(int d, const Vec<3>& x) {
  std::seed_seq seed{d, static_cast<int>(2 * x[0]), static_cast<int>(2 * x[1]),
                     static_cast<int>(2 * x[2])};
  std::minstd_rand random(seed);
  return std::normal_distribution<double>()(random);
}

TEST(GridScale, OfAWaveFollowsFromItsLength) {
  auto box = periodic_box<2>();
  for (const int cells : {2, 4, 8, 16}) {
    box.start_from([&](int d, const Vec<2>& x) {
      return d == 1 ? 3 * std::cos(2 * std::numbers::pi / cells * (x[0] - 0.5)) : 0;
    });
    EXPECT_NEAR(share(box)[0], std::pow(std::sin(std::numbers::pi / cells), 4), 1e-12) << cells;
    EXPECT_NEAR(share(box)[1], 0, 1e-12);
  }
}

TEST(GridScale, OfWhiteNoiseIsThreeEighths) {
  auto box = periodic_box<3>();
  box.start_from([](int d, const Vec<3>& x) { return noise(d, x); });
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(share(box)[axis], 0.375, 0.01);
}

/// The Taylor-Green vortex over 16 cells is resolved: each component is a wave along both axes.
TEST(GridScale, OfAResolvedVortexIsSmall) {
  auto box = periodic_box<2>();
  const double k = 2 * std::numbers::pi / 16;
  box.start_from([&](int d, const Vec<2>& x) {
    return d == 0 ? std::sin(k * x[0]) * std::cos(k * x[1])
                  : -std::cos(k * x[0]) * std::sin(k * x[1]);
  });
  const double expected = std::pow(std::sin(std::numbers::pi / 16), 4);
  EXPECT_NEAR(share(box)[0], expected, 1e-12);
  EXPECT_NEAR(share(box)[1], expected, 1e-12);
}

/// Noise of a thousandth of the energy of water that all moves at 1 m/s counts for a tenth; where
/// the water is as fast as what drives it nothing changes.
TEST(GridScale, OfSlowWaterCountsLess) {
  auto box = periodic_box<3>();
  box.start_from([](int d, const Vec<3>& x) { return std::sqrt(1e-3 / 3) * noise(d, x); });
  const auto share_at = [&](double speed) {
    return grid_scale_energy<3>(box.grid, box.flow.velocity(), box.mapping.open(), speed)[0];
  };
  EXPECT_NEAR(share_at(1), 0.0375, 0.002);
  EXPECT_NEAR(share_at(0.1), 0.375, 0.01);
  EXPECT_EQ(share_at(0.1), share(box)[0]);
}

TEST(GridScale, OfStillWaterIsNone) { EXPECT_EQ(share(periodic_box<3>()), Vec<3>(0, 0, 0)); }

/// Water and solids that turn together are smooth, and what is inside solids does not count.
TEST(GridScale, CountsOpenFacesOnly) {
  WaterBox<2> box(annulus(2.5, 32, 0.4, constant_speed(1), constant_speed(1), 0.1));
  box.mapping.update(0);
  box.start_from([](int d, const Vec<2>& x) { return d == 0 ? -x[1] : x[0]; });
  EXPECT_LT(share(box).maxCoeff(), 1e-20);
  for (int d = 0; d < 2; ++d)
    box.for_cells([&](const Index<2>& c, long p) {
      if (box.mapping.open()[d][p] == 0) box.flow.velocity()[d][p] = c[0] % 2 == 0 ? 5 : -5;
    });
  EXPECT_LT(share(box).maxCoeff(), 1e-20);
}

}  // namespace
}  // namespace washtub
