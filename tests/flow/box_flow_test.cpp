#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "solid/agitator.hpp"
#include "support/water_box.hpp"

namespace washtub {
namespace {

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

constexpr double omega = 3;

double rigid(int d, const Vec<2>& x) { return d == 0 ? -omega * x[1] : omega * x[0]; }

/// A ring, fins and the water between them, all turning alike for 0.06 s.
std::unique_ptr<WaterBox<2>> turn_together(double viscosity, int steps) {
  const double inf = std::numeric_limits<double>::infinity();
  const Drive drive = constant_speed(omega);
  auto box = std::make_unique<WaterBox<2>>(
      WaterSetup<2>{.mesh = cubic_mesh<2>(Vec<2>::Constant(-1.1), 2.2, 64),
                    .solids = {{"ring", complement(cylinder(1, -inf, inf)), Vec<3>::Zero(), drive},
                               {"fins", shape(reference_agitator_2d(1)), Vec<3>::Zero(), drive}},
                    .density = 2,
                    .viscosity = viscosity});
  box->start_from(rigid);
  for (int s = 0; s < steps; ++s) box->step(0.06 / steps, 1e-12);
  return box;
}

/// u = Omega x r solves the discrete equations (its convection is linear in space), even while fins
/// open and close faces; pressure balances the centrifugal force, p = rho Omega^2 r^2 / 2.
TEST(BoxFlow, SolidsTurningWithTheWaterLeaveItRigid) {
  const auto water = turn_together(1e-9, 20);
  const auto& box = *water;
  EXPECT_LE(box.error(rigid), 1e-9);
  double least = 1e30, most = -1e30;
  box.for_cells([&](const Index<2>& c, long p) {
    if (box.flow.multigrid().inverse_diagonal()[p] == 0) return;
    const double rest =
        box.flow.pressure()[p] - 0.5 * 2 * omega * omega * box.grid.position(c).squaredNorm();
    least = std::min(least, rest);
    most = std::max(most, rest);
  });
  EXPECT_LE(box.grid.parallel().max(most) - box.grid.parallel().min(least), 1e-6);
}

/// With viscosity the predictor holds closed faces at u_o while open ones lack the pressure
/// gradient: an error at the surface of order dt (nu dt / h^2) that must vanish with the step.
TEST(BoxFlow, ViscousSplittingErrorAtTurningSolidsVanishesWithTheStep) {
  const double coarse = turn_together(0.02, 20)->error(rigid);
  const double fine = turn_together(0.02, 40)->error(rigid);
  EXPECT_LE(coarse, 1.5e-3 * omega);
  EXPECT_LE(fine, 0.6 * coarse);
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
