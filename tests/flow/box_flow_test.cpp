#include <gtest/gtest.h>

#include <numbers>

#include "solid/agitator.hpp"
#include "support/water_box.hpp"

namespace washtub {
namespace {

using testing::BoxSides;
using testing::cubic_mesh;
using testing::WaterBox;
using testing::WaterSetup;

/// Plane Couette flow: the wall above moves along `flow` at speed 1, `normal` is across the gap.
template <int D>
WaterSetup<D> plane_couette(int flow, int normal, int n) {
  WaterSetup<D> s{.mesh = cubic_mesh<D>(Vec<D>::Zero(), 1, n, true)};
  s.mesh.periodic[normal] = false;
  s.sides[normal][1].velocity[flow] = 1;
  return s;
}

/// The linear profile is a fixed point of the scheme: only round-off may grow.
TEST(BoxFlow, LinearProfileBetweenWallsStays) {
  for (int flow = 0; flow < 3; ++flow)
    for (int normal = 0; normal < 3; ++normal) {
      if (flow == normal) continue;
      WaterBox<3> box(plane_couette<3>(flow, normal, 16));
      const auto exact = [&](int d, const Vec<3>& x) { return d == flow ? x[normal] : 0.0; };
      box.start_from(exact);
      for (int s = 0; s < 5; ++s) box.step(0.01, 1e-12);
      EXPECT_LE(box.error(exact), 1e-12) << "flow along " << flow << ", walls across " << normal;
    }
}

/// From rest the wall drags the water along; after 25 times H^2/(pi^2 nu) the profile is linear.
TEST(BoxFlow, MovingWallDragsTheWaterIntoALinearProfile) {
  for (int flow = 0; flow < 2; ++flow) {
    WaterBox<2> box(plane_couette<2>(flow, 1 - flow, 16));
    for (int s = 0; s < 250; ++s) box.step(0.01, 1e-10);
    EXPECT_LE(box.error([&](int d, const Vec<2>& x) { return d == flow ? x[1 - flow] : 0.0; }),
              1e-9);
  }
}

TEST(BoxFlow, SlipSidesKeepAUniformStream) {
  for (int along = 0; along < 3; ++along) {
    WaterSetup<3> s{.mesh = cubic_mesh<3>(Vec<3>::Zero(), 1, 16), .viscosity = 0.1};
    s.mesh.periodic[along] = true;
    for (auto& axis : s.sides)
      for (auto& side : axis) side.kind = Side<3>::Kind::slip;
    WaterBox<3> box(s);
    const auto stream = [&](int d, const Vec<3>&) { return d == along ? 2.0 : 0.0; };
    box.start_from(stream);
    Flow<3>::Report report;
    for (int n = 0; n < 10; ++n) report = box.step(0.01, 1e-12);
    EXPECT_LE(box.error(stream), 1e-13) << "along " << along;
    EXPECT_NEAR(report.kinetic, 0.5 * 2 * 2, 1e-12);  // rho/2 U^2 times a volume of one
    EXPECT_NEAR(report.courant, 2 * 16, 1e-10);
  }
}

/// A ring, fins and the water between them, all turning alike: u = Omega x r solves the discrete
/// equations (its convection is linear in space), even while fins open and close faces.
TEST(BoxFlow, SolidsTurningWithTheWaterLeaveItRigid) {
  const double inf = std::numeric_limits<double>::infinity(), omega = 3;
  WaterBox<2> box(
      {.mesh = cubic_mesh<2>(Vec<2>::Constant(-1.1), 2.2, 64),
       .solids = {{"ring", complement(cylinder(1, -inf, inf)), Vec<3>::Zero(),
                   constant_speed(omega)},
                  {"fins", shape(reference_agitator_2d(1)), Vec<3>::Zero(), constant_speed(omega)}},
       .density = 2,
       .viscosity = 0.01});
  const auto rigid = [&](int d, const Vec<2>& x) { return d == 0 ? -omega * x[1] : omega * x[0]; };
  box.start_from(rigid);
  for (int s = 0; s < 20; ++s) box.step(3e-3, 1e-12);
  EXPECT_LE(box.error(rigid), 1e-9 * omega);
  // Pressure balances the centrifugal force: p = rho Omega^2 r^2 / 2 up to a constant.
  double least = 1e30, most = -1e30;
  box.for_cells([&](const Index<2>& c, long p) {
    if (box.flow.multigrid().inverse_diagonal()[p] == 0) return;
    const double rest =
        box.flow.pressure()[p] - 0.5 * 2 * omega * omega * box.grid.position(c).squaredNorm();
    least = std::min(least, rest);
    most = std::max(most, rest);
  });
  EXPECT_LE(box.grid.parallel().max(most) - box.grid.parallel().min(least), 1e-6);
  EXPECT_NEAR(box.torque(1), 0, 1e-6);
}

/// Taylor-Green vortex in three dimensions. Kinetic energy only falls, at the rate 6 nu E of the
/// start, while convection has not yet made small scales.
TEST(BoxFlow, KineticEnergyOfATaylorGreenVortexDecays) {
  const double nu = 0.01, dt = 0.05;
  WaterBox<3> box(
      {.mesh = cubic_mesh<3>(Vec<3>::Zero(), 2 * std::numbers::pi, 24, true), .viscosity = nu});
  box.start_from([](int d, const Vec<3>& x) {
    if (d == 0) return std::sin(x[0]) * std::cos(x[1]) * std::cos(x[2]);
    if (d == 1) return -std::cos(x[0]) * std::sin(x[1]) * std::cos(x[2]);
    return 0.0;
  });
  double before = std::pow(2 * std::numbers::pi, 3) / 8;
  const double start = before;
  for (int s = 1; s <= 60; ++s) {
    const double energy = box.step(dt, 1e-8).kinetic;
    EXPECT_LT(energy, before) << "step " << s;
    before = energy;
    if (s == 4) {
      EXPECT_NEAR(energy / start, std::exp(-6 * nu * 4 * dt), 3e-4);
    }
  }
}

}  // namespace
}  // namespace washtub
