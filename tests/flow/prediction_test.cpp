#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <stdexcept>

#include "support/wash_tub.hpp"

namespace washtub {
namespace {

using testing::cubic_mesh;
using testing::WaterBox;
using testing::WaterSetup;

constexpr double pi = std::numbers::pi;

/// Vortex at rest on all sides of the unit square, divergence-free.
Vec<2> square_vortex(const Vec<2>& x) {
  const double a = pi * x[0], b = pi * x[1];
  return {std::pow(std::sin(a), 2) * std::sin(2 * b), -std::pow(std::sin(b), 2) * std::sin(2 * a)};
}

std::unique_ptr<WaterBox<2>> square_box(double viscosity) {
  auto box = std::make_unique<WaterBox<2>>(
      WaterSetup<2>{.mesh = cubic_mesh<2>(Vec<2>::Zero(), 1, 32), .viscosity = viscosity});
  box->flow.set_velocity(square_vortex);
  return box;
}

double difference(const WaterBox<2>& a, const WaterBox<2>& b) {
  double largest = 0;
  for (int d = 0; d < 2; ++d)
    a.for_cells([&](const Index<2>&, long p) {
      largest = std::max(largest, std::abs(a.flow.velocity()[d][p] - b.flow.velocity()[d][p]));
    });
  return a.grid.parallel().max(largest);
}

TEST(Prediction, SecondOrderInTimeBetweenWalls) {
  for (const double viscosity : {0.01, 0.1}) {
    std::array<std::unique_ptr<WaterBox<2>>, 3> runs;
    for (int i = 0; i < 3; ++i) {
      runs[i] = square_box(viscosity);
      for (int s = 0; s < 20 << i; ++s) runs[i]->step(0.2 / (20 << i), 1e-11);
    }
    const double first = difference(*runs[0], *runs[1]), second = difference(*runs[1], *runs[2]);
    EXPECT_GT(first / second, 3.5) << "viscosity " << viscosity;
    EXPECT_LE(first, 3e-4);
  }
}

/// A shear wave in a periodic box of an odd number of cells, where two cells of one colour meet:
/// the Crank-Nicolson step of this very grid, at diffusion numbers that call for sweeps, many
/// sweeps, or none: then the wave q loses 2 q - 2 q^2 to two explicit steps, which misses 2 q^3.
TEST(Prediction, DampsAShearWaveAcrossOddPeriodicSides) {
  constexpr int n = 33;
  for (const double diffusion : {0.04, 0.06, 0.3, 30.0})
    for (const int across : {0, 1}) {
      const double dt = diffusion / (n * n);
      WaterBox<2> box({.mesh = cubic_mesh<2>(Vec<2>::Zero(), 1, n, true)});
      const auto wave = [&](int d, const Vec<2>& x) {
        return d == across ? 0.0 : std::sin(2 * pi * x[across]) + std::cos(16 * pi * x[across]);
      };
      box.flow.set_velocity([&](const Vec<2>& x) { return Vec<2>(wave(0, x), wave(1, x)); });
      box.step(dt, 1e-10);
      const auto number = [&](int waves) { return diffusion * (1 - std::cos(2 * pi * waves / n)); };
      const auto left = [&](int waves) { return (1 - number(waves)) / (1 + number(waves)); };
      EXPECT_LE(box.error([&](int d, const Vec<2>& x) {
        return d == across ? 0.0
                           : left(1) * std::sin(2 * pi * x[across]) +
                                 left(8) * std::cos(16 * pi * x[across]);
      }),
                diffusion < 0.05 ? 2 * std::pow(number(8), 3) : 1e-5)
          << "diffusion number " << diffusion << ", across axis " << across;
    }
}

/// A steady force that is a gradient is balanced by the pressure and moves nothing, however large.
TEST(Prediction, GradientForceLeavesWaterAtRest) {
  const auto box = square_box(0.1);
  box->flow.set_velocity([](const Vec<2>&) { return Vec<2>(0, 0); });
  box->for_cells([&](const Index<2>& c, long p) {
    const Vec<2> y = box->grid.position(c, 1);
    box->flow.force()[1][p] = 100 * std::cos(3 * y[1]);
  });
  for (int s = 0; s < 6; ++s) box->step(0.01, 1e-10);
  EXPECT_LE(box->error([](int, const Vec<2>&) { return 0.0; }), 1e-9);
}

TEST(Prediction, ProvisionalIsThePredictionWithForceAndPressure) {
  const auto box = square_box(0.1);
  for (int s = 0; s < 4; ++s) box->step(0.01, 1e-10);
  const double dt = 0.01;
  box->flow.predict(dt);
  box->for_cells([&](const Index<2>&, long p) { box->flow.force()[0][p] = 0.3; });
  const auto provisional = box->flow.provisional();
  const auto& pressure = box->flow.pressure();
  double largest = 0;
  box->for_open_faces([&](int d, const Vec<2>&, long p) {
    const double slope =
        (pressure[p] - pressure[p - box->grid.block().stride[d]]) / box->grid.mesh().h[d];
    const double expected = box->flow.velocity()[d][p] + dt * ((d == 0 ? 0.3 : 0.0) - slope);
    largest = std::max(largest, std::abs(provisional.component(d)(p) - expected));
  });
  EXPECT_LE(box->grid.parallel().max(largest), 1e-14);
}

/// A step whose projection is repeated, once with a wrong force and once with the right one, is the
/// step, and so are those that follow.
TEST(Prediction, ProjectionCanBeRepeatedWithAnotherForce) {
  const auto once = square_box(0.01), again = square_box(0.01);
  const auto push = [](WaterBox<2>& box, double force) {
    box.for_open_faces([&](int d, const Vec<2>& x, long p) {
      box.flow.force()[d][p] = d == 0 ? force * std::sin(pi * x[1]) : 0.0;
    });
  };
  for (int s = 0; s < 6; ++s) {
    for (auto* box : {once.get(), again.get()}) box->flow.predict(0.01);
    push(*once, 1);
    once->flow.project(1e-11, 60);
    again->flow.keep_prediction();
    for (const double force : {-5.0, 1.0}) {
      again->flow.return_to_prediction();
      push(*again, force);
      EXPECT_TRUE(again->flow.project(1e-11, 60).pressure.converged);
    }
    EXPECT_LE(difference(*once, *again), 1e-10) << "step " << s;
  }
}

/// Another projection with the same force finds nothing left to do.
TEST(Prediction, RepeatedProjectionStartsFromTheLastPressure) {
  const auto box = square_box(0.01);
  for (int s = 0; s < 5; ++s) {
    box->flow.predict(0.01);
    box->flow.keep_prediction();
    box->flow.project(1e-6, 60);
    box->flow.return_to_prediction();
    EXPECT_EQ(box->flow.project(1.01e-6, 60).pressure.cycles, 0) << "step " << s;
  }
}

/// Calls out of order are refused and leave the flow as it was.
TEST(Prediction, CallsOutOfOrderAreRefused) {
  const auto box = square_box(0.01);
  auto& flow = box->flow;
  const auto too_early = [&] {
    EXPECT_THROW(flow.project(1e-6, 60), std::logic_error);
    EXPECT_THROW(flow.provisional(), std::logic_error);
    EXPECT_THROW(flow.keep_prediction(), std::logic_error);
    EXPECT_THROW(flow.return_to_prediction(), std::logic_error);
  };
  for (int s = 0; s < 2; ++s) {
    too_early();
    flow.openings_changed(0, box->grid.block().planes(), false);
    flow.predict(0.01);
    EXPECT_THROW(flow.predict(0.01), std::logic_error);
    EXPECT_THROW(flow.openings_changed(0, 1, true), std::logic_error);
    EXPECT_THROW(flow.return_to_prediction(), std::logic_error);
    flow.keep_prediction();
    flow.project(1e-6, 60);
    EXPECT_THROW(flow.set_velocity(square_vortex), std::logic_error);
    EXPECT_THROW(flow.keep_prediction(), std::logic_error);
    flow.return_to_prediction();
    EXPECT_THROW(flow.keep_prediction(), std::logic_error);
    flow.project(1e-6, 60);
    flow.predict(0.01);  // what was kept in the step before is forgotten
    EXPECT_THROW(flow.return_to_prediction(), std::logic_error);
    flow.project(1e-6, 60);
  }
}

/// One dt is given for a step, and the parts of it find it there.
TEST(Prediction, StepIsThatOfThePrediction) {
  const auto box = square_box(0.01);
  auto& flow = box->flow;
  EXPECT_EQ(flow.step(), 0);
  for (const double dt : {0.01, 0.02, 0.005}) {
    const double last = flow.step();
    EXPECT_FALSE(flow.predicted());
    flow.predict(dt);
    EXPECT_TRUE(flow.predicted());
    EXPECT_EQ(flow.step(), dt);
    EXPECT_EQ(flow.step_before(), last);
    flow.project(1e-6, 60);
  }
}

/// Water that turns as a solid between solids that turn: start and ghosts are exact.
TEST(Prediction, SetVelocityFillsOpenFacesAndGhosts) {
  const auto field = [](const Vec<3>& x) { return Vec<3>(x[1] * x[2], -x[0] + x[2], 1 + x[0]); };
  auto mesh = cubic_mesh<3>(Vec<3>::Constant(-0.5), 1, 16);
  WaterSetup<3> s{
      .mesh = mesh,
      .solids = {{"ball", sphere(Vec<3>::Zero(), 0.2), Vec<3>::Zero(), constant_speed(2)}}};
  s.sides[0] = {Side<3>{Side<3>::Kind::inflow, Vec<3>(0, 0, 3)}, Side<3>{Side<3>::Kind::outflow}};
  WaterBox<3> box(s);
  box.impose();
  box.flow.set_velocity(field);
  EXPECT_EQ(box.error([&](int d, const Vec<3>& x) { return field(x)[d]; }), 0);
  const auto& block = box.grid.block();
  const auto open = box.mapping.open();
  double solid = 0, beyond = 0, inflow = 0;
  for (int d = 0; d < 3; ++d)
    box.for_cells([&](const Index<3>& c, long p) {
      const Vec<3> x = box.grid.position(c, d);
      const double u = box.flow.velocity()[d][p];
      const bool in_ball = open[d][p] == 0 && x.norm() < 0.3;
      if (in_ball) solid = std::max(solid, std::abs(u - 2 * Vec<3>(-x[1], x[0], 0)[d]));
      Index<3> next = c;
      ++next[0];
      const double outside = box.flow.velocity()[d][p + 1] - field(box.grid.position(next, d))[d];
      const bool inside =
          (d != 1 || block.offset[1] + c[1] > 0) && (d != 2 || block.offset[2] + c[2] > 0);
      if (c[0] == 15 && inside) beyond = std::max(beyond, std::abs(outside));
      if (c[0] == 0 && d == 2 && inside)
        inflow = std::max(inflow, std::abs(0.5 * (u + box.flow.velocity()[d][p - 1]) - 3));
    });
  const auto& parallel = box.grid.parallel();
  EXPECT_LE(parallel.max(solid), 1e-15);
  EXPECT_LE(parallel.max(beyond), 1e-15);
  EXPECT_LE(parallel.max(inflow), 1e-15);
}

}  // namespace
}  // namespace washtub
