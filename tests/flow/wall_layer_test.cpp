#include <gtest/gtest.h>

#include "flow/annulus.hpp"

namespace washtub {
namespace {

using testing::annulus;
using testing::WaterBox;
using testing::WaterSetup;

constexpr double omega = 6;

/// A tub with a fin in it that turns with the water, off the grid's axes.
WaterSetup<2> turning_together(const Heaviside& heaviside) {
  auto setup = annulus(2.4, 48, 0.2, constant_speed(omega), constant_speed(omega), 1e-3, heaviside);
  setup.solids[1].shape = capsule(Vec<3>(-0.5, 0, 0), Vec<3>(0.5, 0, 0), 0.06);
  return setup;
}

/// Root mean square over the steps of the torque on the fin.
struct Torque {
  double counted = 0;   ///< as SurfaceWater counts
  double of_faces = 0;  ///< where each face that opens or closes counts with all its momentum
};

Torque torque_on_fin(const Heaviside& heaviside) {
  WaterBox<2> box(turning_together(heaviside));
  box.start_from([](int d, const Vec<2>& x) { return omega * (d == 0 ? -x[1] : x[0]); });
  const double dt = 2e-3;
  const int steps = 60;
  std::array<double, 2> squares{};
  for (int s = 0; s < steps; ++s) {
    const double before = box.surface_water.momentum(1, box.flow.velocity()).torque;
    box.t += dt;
    const auto change = box.mapping.update(box.t);
    double moment = box.surface_water.joined(1, box.flow.velocity()).torque;
    if (change.any) box.flow.openings_changed(0, box.grid.block().planes(), change.flipped);
    box.impose();
    box.flow.predict(dt);
    box.flow.project(1e-8, 60);
    moment += dt * box.loads(1).total().torque;
    squares[1] += std::pow(box.grid.parallel().sum(moment) / dt, 2);
    moment += before - box.surface_water.momentum(1, box.flow.velocity()).torque;
    squares[0] += std::pow(box.grid.parallel().sum(moment) / dt, 2);
  }
  return {std::sqrt(squares[0] / steps), std::sqrt(squares[1] / steps)};
}

/// Faces that open and close give a solid that turns with the water next to nothing, where the
/// momentum of each that a sharp mapping flips is noise.
TEST(WallLayer, NoTorqueWhereWaterTurnsWithTheSolid) {
  const Torque sharp = torque_on_fin(Heaviside::sharp());
  EXPECT_GT(sharp.of_faces, 1);
  EXPECT_LE(sharp.counted, 0.02 * sharp.of_faces);
  EXPECT_LE(torque_on_fin(Heaviside::smooth(0.1)).counted, 0.02 * sharp.of_faces);
  EXPECT_LE(torque_on_fin(Heaviside::gradual()).counted, 0.02 * sharp.of_faces);
}

/// Largest speed on one side of an oblique wall through a box, after a force has stirred the water
/// on the other side.
double leak(double thickness) {
  const Vec<3> along(std::cos(0.4), std::sin(0.4), 0);
  WaterSetup<2> setup{.mesh = testing::cubic_mesh<2>(Vec<2>::Constant(-0.5), 1, 32),
                      .solids = {{"wall", capsule(-2 * along, 2 * along, 0.5 * thickness),
                                  Vec<3>(0.01, 0.007, 0), at_rest()}},
                      .density = 1,
                      .viscosity = 0.01,
                      .heaviside = Heaviside::gradual()};
  WaterBox<2> box(setup);
  const Vec<2> across(-along[1], along[0]);
  for (int s = 0; s < 40; ++s) {
    box.for_open_faces([&](int d, const Vec<2>& x, long p) {
      box.flow.force()[d][p] = x.dot(across) > 0 ? 10 * std::sin(9 * x[1 - d]) : 0;
    });
    box.step(5e-3, 1e-10);
  }
  double stirred = 0, leaked = 0;
  box.for_open_faces([&](int d, const Vec<2>& x, long p) {
    const double height = (x - Vec<2>(0.01, 0.007)).dot(across);
    double& most = height > 0.5 * thickness ? stirred : leaked;
    if (std::abs(height) > 0.5 * thickness)
      most = std::max(most, std::abs(box.flow.velocity()[d][p]));
  });
  return box.grid.parallel().max(leaked) / box.grid.parallel().max(stirred);
}

/// No water and no momentum passes through a wall, however thin.
TEST(WallLayer, ThinWallsAreTight) {
  for (const double cells : {2.0, 1.0, 0.5, 0.1, 0.01})
    EXPECT_LE(leak(cells / 32), 1e-8) << cells << " cells";
}

/// A force along a flat wall drives the water between the wall and a face by the share that the
/// face is open, and all other water in full.
TEST(WallLayer, TakesItsShareOfAForce) {
  constexpr double force = 3, dt = 1e-3;
  WaterSetup<2> setup{.mesh = testing::cubic_mesh<2>(Vec<2>::Zero(), 1, 16),
                      .solids = {{"floor", half_space(Vec<3>(0, 0.205, 0), Vec<3>(0, 1, 0)),
                                  Vec<3>::Zero(), at_rest()}},
                      .density = 2,
                      .viscosity = 1e-12,
                      .heaviside = Heaviside::gradual()};
  setup.mesh.periodic[0] = true;
  WaterBox<2> box(setup);
  box.for_open_faces([&](int d, const Vec<2>&, long p) {
    if (d == 0) box.flow.force()[d][p] = force;
  });
  box.step(dt, 1e-12);
  int partly = 0;
  box.for_open_faces([&](int d, const Vec<2>&, long p) {
    if (d != 0) return;
    const float open = box.mapping.open()[d][p];
    partly += open < 1;
    EXPECT_NEAR(box.flow.velocity()[d][p], dt / setup.density * force * open, 1e-9);
  });
  EXPECT_GT(box.grid.parallel().sum(partly), 0);
}

}  // namespace
}  // namespace washtub
