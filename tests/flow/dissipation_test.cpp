#include "flow/dissipation.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "flow/annulus.hpp"

namespace washtub {
namespace {

using testing::annulus;
using testing::cubic_mesh;
using testing::WaterBox;

double kinetic(const WaterBox<2>& box) {
  double squares = 0;
  box.for_open_faces([&](int d, const Vec<2>&, long p) {
    squares += box.flow.velocity()[d][p] * box.flow.velocity()[d][p];
  });
  return 0.5 * box.flow.density() * box.grid.mesh().cell_volume() *
         box.grid.parallel().sum(squares);
}

/// u = y U/H between walls: the moving one does mu U/H U work on each unit of its area, and the
/// water turns that into heat.
template <int D>
void expect_plane_couette(int flow_axis, int wall_axis) {
  constexpr double U = 3, mu = 0.2;
  Mesh<D> mesh{Vec<D>::Zero(), Vec<D>::Constant(0.25), {}, {}};
  mesh.cells.fill(8);
  for (int d = 0; d < D; ++d) mesh.h[d] *= 1 + d, mesh.periodic[d] = d != wall_axis;
  SidePairs<D> sides{};
  sides[wall_axis][1].velocity[flow_axis] = U;
  WaterBox<D> box({.mesh = mesh, .viscosity = mu, .sides = sides});
  const double H = mesh.size()[wall_axis];
  box.start_from([&](int d, const Vec<D>& x) { return d == flow_axis ? U * x[wall_axis] / H : 0; });
  const double expected = mu * U * U / H * mesh.size().prod() / H;
  EXPECT_NEAR(dissipation(box.flow), expected, 1e-12 * expected);
  EXPECT_NEAR(power_of_sides<D>(box.flow, sides), expected, 1e-12 * expected);
}

TEST(Dissipation, OfShearBetweenWalls) {
  expect_plane_couette<2>(0, 1);
  expect_plane_couette<2>(1, 0);
  for (int flow_axis = 0; flow_axis < 3; ++flow_axis)
    for (const int turn : {1, 2}) expect_plane_couette<3>(flow_axis, (flow_axis + turn) % 3);
}

/// Components that strain each other: 2 mu S:S of the Taylor-Green vortex is 4 mu k^2 cos^2 cos^2,
/// and its mean mu k^2.
TEST(Dissipation, OfAVortex) {
  constexpr double mu = 0.3;
  const int n = 32;
  WaterBox<2> box(
      {.mesh = cubic_mesh<2>(Vec<2>::Zero(), 2 * std::numbers::pi, n, true), .viscosity = mu});
  box.start_from([](int d, const Vec<2>& x) {
    return d == 0 ? std::sin(x[0]) * std::cos(x[1]) : -std::cos(x[0]) * std::sin(x[1]);
  });
  const double h = 2 * std::numbers::pi / n, slope = std::sin(h / 2) / (h / 2);
  const double expected = mu * slope * slope * std::pow(2 * std::numbers::pi, 2);
  EXPECT_NEAR(dissipation(box.flow), expected, 1e-12 * expected);
}

TEST(Dissipation, IsNoneWhereAllTurnsTogether) {
  WaterBox<2> box(annulus(2.5, 32, 0.4, constant_speed(1), constant_speed(1), 0.1));
  box.mapping.update(0);
  box.start_from([](int d, const Vec<2>& x) { return d == 0 ? -x[1] : x[0]; });
  EXPECT_LT(dissipation(box.flow), 1e-20);
}

/// Kinetic energy that a decaying vortex, carried along by a stream, loses beyond the dissipation,
/// over what it loses.
double lost_beyond(int steps) {
  constexpr double mu = 0.05, time = 1;
  WaterBox<2> box(
      {.mesh = cubic_mesh<2>(Vec<2>::Zero(), 2 * std::numbers::pi, 32, true), .viscosity = mu});
  box.start_from([](int d, const Vec<2>& x) {
    return d == 0 ? 1 + std::sin(x[0]) * std::cos(x[1]) : 0.5 - std::cos(x[0]) * std::sin(x[1]);
  });
  const double start = kinetic(box), dt = time / steps;
  double heat = 0, before = dissipation(box.flow);
  for (int s = 0; s < steps; ++s) {
    box.step(dt, 1e-11);
    const double now = dissipation(box.flow);
    heat += 0.5 * dt * (before + now);
    before = now;
  }
  return (start - kinetic(box) - heat) / heat;
}

/// In a box without sides and solids the energy balance closes to the order of the steps in time.
TEST(Dissipation, IsWhatADecayingVortexLoses) {
  const double coarse = lost_beyond(40), fine = lost_beyond(80);
  EXPECT_LT(std::abs(fine), 2e-3);
  EXPECT_GT(coarse / fine, 3);
}

/// Circular Couette flow (reference.md, section 5) on 128 cells: the turning disc and ring put in
/// what becomes heat, T (omega_i - omega_o).
TEST(VerificationDissipation, IsThePowerOfTheDrivesInCouetteFlow) {
  constexpr double omega_i = 6.13, torque = 0.04245, power = torque * (omega_i - 1);
  WaterBox<2> box(annulus(2.82, 128, 0.34, constant_speed(omega_i), constant_speed(1), 0.66 / 131));
  box.start_from([](int d, const Vec<2>& x) {
    const double r = x.norm();
    const double spin = r < 0.34 ? omega_i : r < 1 ? 0.32946 + 0.67054 / (r * r) : 1.0;
    return spin * (d == 0 ? -x[1] : x[0]);
  });
  const double dt = 0.25 * (2.82 / 128) / (omega_i * 0.34);
  double put_in = 0, heat = 0, time = 0, start = 0;
  for (int s = 0; s < 1000; ++s) {
    box.step(dt, 1e-6);
    if (s == 500) start = kinetic(box);
    if (s <= 500) continue;
    put_in -= dt * (box.torque(0) + omega_i * box.torque(1));
    heat += dt * dissipation(box.flow);
    time += dt;
  }
  EXPECT_NEAR(heat / time, power, 0.08 * power);
  EXPECT_NEAR(put_in, heat + kinetic(box) - start, 0.03 * power * time);
}

}  // namespace
}  // namespace washtub
