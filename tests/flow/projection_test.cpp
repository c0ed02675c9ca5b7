#include <gtest/gtest.h>

#include "support/wash_tub.hpp"

namespace washtub {
namespace {

using testing::WashTub;

constexpr double dt = 5e-3 / testing::peak_speed;  // 40 times the paper's step

/// Root mean square of |div u| over the cells of water, found from the faces [1/s].
double mean_divergence(const WashTub& tub) {
  std::array<double, 2> sums{};
  tub.for_cells([&](const Index<3>&, long p) {
    if (tub.flow.multigrid().inverse_diagonal()[p] == 0) return;
    sums[0] += std::pow(tub.divergence(p), 2);
    sums[1] += 1;
  });
  tub.grid.parallel().sum(std::span<double>(sums));
  return std::sqrt(sums[0] / sums[1]);
}

/// On return of project(), |div u| h <= tolerance U in the root mean square and 100 times that in
/// every water cell, and the report says how much: measured from the faces, with the agitator
/// opening and closing faces at every step.
TEST(Projection, DivergenceIsWithinTheToleranceAskedFor) {
  for (const double tolerance : {1e-4, 1e-10}) {
    WashTub tub(32, 1);
    tub.t = 0.2;
    for (int s = 0; s < 4; ++s) {
      const auto report = tub.step(dt, tolerance);
      const double scale = tub.grid.mesh().h.maxCoeff() / report.speed;
      EXPECT_TRUE(report.pressure.converged);
      EXPECT_LE(report.divergence, tolerance);
      const double rms = mean_divergence(tub) * scale, largest = tub.largest_divergence() * scale;
      EXPECT_LE(std::max(rms, largest / 100), 1.01 * tolerance + 1e-14);
      EXPECT_NEAR(report.divergence, std::max(rms, largest / 100), 0.05 * tolerance);
    }
  }
}

/// What the default tolerance lets through the middle of the closed tub, where nothing may pass on
/// the whole, while the agitator turns: of the tub's water, and of what goes to and fro there.
TEST(Projection, NoWaterIsLostThroughTheMiddleOfTheTub) {
  WashTub tub(32, 1);
  tub.t = 0.2;
  const auto& h = tub.grid.mesh().h;
  std::array<double, 3> sums{};  // net, gross, volume of water [m^3]
  const auto middle = [&](const Index<3>& c) { return c[2] + tub.grid.block().offset[2] == 16; };
  for (int s = 0; s < 40; ++s) {
    tub.step(dt);
    tub.for_cells([&](const Index<3>& c, long p) {
      if (!middle(c)) return;
      const double volume = dt * h[0] * h[1] * tub.flow.velocity()[2][p];
      sums[0] += volume, sums[1] += std::abs(volume);
    });
  }
  tub.for_cells([&](const Index<3>&, long p) {
    if (tub.flow.multigrid().inverse_diagonal()[p] > 0) sums[2] += h.prod();
  });
  tub.grid.parallel().sum(std::span<double>(sums));
  EXPECT_LE(std::abs(sums[0]), 1e-5 * sums[2]);
  EXPECT_LE(std::abs(sums[0]), 1e-2 * sums[1]);
}

TEST(Projection, ClosedFacesKeepTheVelocityOfTheirSolid) {
  WashTub tub(32, 1);
  tub.t = 0.2;
  for (int s = 0; s < 3; ++s) tub.step(dt);
  const auto open = tub.mapping.open();
  double largest = 0;
  for (int d = 0; d < 3; ++d)
    tub.for_cells([&](const Index<3>& c, long p) {
      if (open[d][p] > 0 || (c[d] == 0 && tub.grid.at_side(d, 0))) return;
      const auto& solid = tub.mapping.solids()[tub.mapping.owner(d)[p]];
      const double exact = solid.velocity(tub.grid.position(c, d), tub.t)[d];
      largest = std::max(largest, std::abs(tub.flow.velocity()[d][p] - exact));
    });
  EXPECT_LE(largest, 1e-13);
}

TEST(Projection, SpeedCourantNumberAndKineticEnergyAreThoseOfTheField) {
  WashTub tub(32, 1);
  tub.t = 0.2;
  Flow<3>::Report report;
  for (int s = 0; s < 2; ++s) report = tub.step(dt);
  double speed = 0, energy = 0;
  const auto open = tub.mapping.open();
  for (int d = 0; d < 3; ++d)
    tub.for_cells([&](const Index<3>&, long p) {
      const double u = tub.flow.velocity()[d][p];
      if (open[d][p] > 0) speed = std::max(speed, std::abs(u));
      energy += 500 * tub.grid.mesh().cell_volume() * open[d][p] * u * u;
    });
  speed = tub.grid.parallel().max(speed);
  energy = tub.grid.parallel().sum(energy);
  EXPECT_GE(report.speed, speed);
  EXPECT_LE(report.speed, testing::peak_speed * testing::tub_radius * 2);
  EXPECT_NEAR(report.kinetic, energy, 1e-12 * energy);
  EXPECT_GE(report.courant, speed / tub.grid.mesh().h[0]);
  EXPECT_LE(report.courant, 3 * report.speed / tub.grid.mesh().h.minCoeff());
}

/// Pressure of cells without an open face is zero, so that loads may sum over them.
TEST(Projection, NoPressureInsideSolids) {
  WashTub tub(32, 1);
  tub.t = 0.2;
  for (int s = 0; s < 3; ++s) tub.step(dt);
  double largest = 0;
  tub.for_cells([&](const Index<3>&, long p) {
    if (tub.flow.multigrid().inverse_diagonal()[p] == 0)
      largest = std::max(largest, std::abs(tub.flow.pressure()[p]));
  });
  EXPECT_EQ(largest, 0);
}

/// The same wash on the ranks of this run and on one: only round-off may differ.
TEST(Projection, TwentyStepsAgreeOnAnyNumberOfRanks) {
  WashTub many(32, 0.1), one(32, 0.1, true, Parallel(MPI_COMM_SELF));
  many.t = one.t = 0.2;
  double speed = 0;
  for (int s = 0; s < 20; ++s) {
    many.step(dt);
    speed = one.step(dt).speed;
  }
  double velocity = 0, pressure = 0, largest = 0;
  many.for_cells([&](Index<3> c, long p) {
    for (int d = 0; d < 3; ++d) c[d] += many.grid.block().offset[d];
    const long q = one.grid.block().at(c);
    for (int d = 0; d < 3; ++d)
      velocity =
          std::max(velocity, std::abs(many.flow.velocity()[d][p] - one.flow.velocity()[d][q]));
    pressure = std::max(pressure, std::abs(many.flow.pressure()[p] - one.flow.pressure()[q]));
    largest = std::max(largest, std::abs(one.flow.pressure()[q]));
  });
  EXPECT_LE(velocity, 1e-9 * speed);
  EXPECT_LE(pressure, 1e-9 * largest);
  for (std::size_t solid = 0; solid < 2; ++solid) {
    const double alone = one.torque(solid);
    EXPECT_NEAR(many.torque(solid), alone, 1e-8 * std::abs(alone)) << solid;
  }
}

}  // namespace
}  // namespace washtub
