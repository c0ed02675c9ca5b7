#include "record/observer.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace washtub {
namespace {

Case box() {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {32, 32, 1};
  whole.time.end = 1;
  return whole;
}

ClothCase thread() {
  ClothCase cloth;
  cloth.arrangement = Arrangement::sheet;
  cloth.size = {0.4, 0};
  cloth.nodes = {9, 1};
  cloth.material = {100, 0, 1e-3, 0, 0, 0, 1e-3};
  return cloth;
}

TEST(Observer, ProbesAreCountedFromBothEnds) {
  Case whole = box();
  whole.cloth = {thread(), thread()};
  whole.cloth[0].origin = {0.3, 0.25, 0};
  whole.cloth[1].origin = {0.3, 0.75, 0};
  whole.probes = {{"root", 1, {0, 0}}, {"tip", 2, {-1, 0}}, {"inner", 2, {2, 0}}};
  Simulation<2> simulation(whole, Parallel());
  const auto probes = Observer<2>(simulation).observe().probes;
  ASSERT_EQ(probes.size(), 3u);
  EXPECT_LT((probes[0] - Vec<3>(0.3, 0.25, 0)).norm(), 1e-15);
  EXPECT_LT((probes[1] - Vec<3>(0.7, 0.75, 0)).norm(), 1e-15);
  EXPECT_LT((probes[2] - Vec<3>(0.4, 0.75, 0)).norm(), 1e-15);
}

TEST(Observer, ProbesOfASheetTakeBothNumbers) {
  Case whole = box();
  whole.dimension = 3;
  whole.domain.size = {1, 1, 1};
  whole.domain.cells = {16, 16, 16};
  whole.cloth = {thread()};
  whole.cloth[0].size = {0.4, 0.2};
  whole.cloth[0].nodes = {9, 5};
  whole.cloth[0].origin = {0.3, 0.4, 0.5};
  whole.probes = {{"corner", 1, {-1, -1}}, {"edge", 1, {8, 2}}};
  Simulation<3> simulation(whole, Parallel());
  const auto probes = Observer<3>(simulation).observe().probes;
  EXPECT_LT((probes[0] - Vec<3>(0.7, 0.6, 0.5)).norm(), 1e-15);
  EXPECT_LT((probes[1] - Vec<3>(0.7, 0.5, 0.5)).norm(), 1e-15);
}

/// The stress of all is the mean of the pieces', that of a group that of its own.
TEST(Observer, StressIsTheMeanOverThePieces) {
  Case whole = box();
  whole.cloth = {thread(), thread()};
  whole.cloth[0].origin = {0.3, 0.25, 0};
  whole.cloth[1].origin = {0.3, 0.75, 0};
  whole.cloth[0].curvature = 1;
  whole.cloth[1].curvature = 2;
  Simulation<2> simulation(whole, Parallel());
  const Sample s = Observer<2>(simulation).observe();
  ASSERT_EQ(s.pieces.size(), 2u);
  ASSERT_EQ(s.groups.size(), 2u);
  const auto of = [](const PieceSample& p) {
    return std::array{p.stress.membrane, p.stress.bending, p.stress.total,
                      p.raw_stress,      p.tension,        p.compression};
  };
  const auto one = of(s.pieces[0]), other = of(s.pieces[1]), group = of(s.groups[1]);
  const std::array all = {s.stress.membrane, s.stress.bending, s.stress.total,
                          s.raw_stress,      s.tension,        s.compression};
  EXPECT_GT(other[2], 1.9 * one[2]);
  for (std::size_t k = 0; k < all.size(); ++k) {
    EXPECT_NEAR(all[k], 0.5 * (one[k] + other[k]), 1e-12 * other[2]);
    EXPECT_NEAR(group[k], other[k], 1e-12 * other[2]);
  }
  EXPECT_NEAR(s.groups[1].centre[1], s.pieces[1].centre[1], 1e-15);
  // Arcs have the same stress all along but at their ends, half of the cloth that of the flatter.
  EXPECT_NEAR(s.groups[1].quantiles[0] / s.groups[0].quantiles[0], 2, 0.05);
  EXPECT_LE(s.quantiles[0], 1.01 * s.groups[0].quantiles[2]);
  EXPECT_DOUBLE_EQ(s.quantiles[2], s.groups[1].quantiles[2]);
}

/// A thread that is pulled to and fro along itself, and one at rest: what is counted edge by edge,
/// per edge and the time since the last sample.
TEST(Observer, StrainCyclesPerEdgeAndTime) {
  Case whole = box();
  whole.output.stress_time = 0;
  whole.time.fixed = true;
  whole.time.step = 5e-3;
  whole.cloth = {thread(), thread()};
  whole.cloth[0].origin = {0.3, 0.25, 0};
  whole.cloth[1].origin = {0.3, 0.75, 0};
  whole.cloth[0].load[0] = "400*(x - 0.5)*sin(60*t)";
  Simulation<2> simulation(whole, Parallel());
  Observer<2> observer(simulation);
  const auto& group = simulation.cloth().groups[0];
  Rainflow expected(8);
  Strains strains;
  double sampled = 0;
  for (int row = 0; row < 3; ++row) {
    for (int i = 0; i < 40; ++i) {
      observer.watch(simulation.step(1));
      find_strains(group.sheet, simulation.cloth().piece(group, 0), strains);
      for (std::size_t edge = 0; edge < 8; ++edge) expected.add(edge, strains.along[1][edge]);
    }
    const Sample s = observer.observe();
    const auto counted = expected.take();
    const double all = 8 * (simulation.time() - sampled);
    sampled = simulation.time();
    EXPECT_GE(counted[0], 8);
    for (std::size_t k = 0; k < counted.size(); ++k) {
      EXPECT_NEAR(s.groups[0].strain_cycles[k], counted[k] / all, 1e-9);
      EXPECT_NEAR(s.strain_cycles[k], 0.5 * counted[k] / all, 1e-9);
    }
    EXPECT_EQ(s.groups[1].strain_cycles[1], 0);
  }
}

TEST(Observer, RingsEncloseTheirArea) {
  Case whole = box();
  for (const double x : {0.25, 0.75}) {
    ClothCase ring = thread();
    ring.arrangement = Arrangement::ring;
    ring.centre = {x, 0.5, 0};
    ring.radius = 0.1;
    ring.size = {0.2 * std::numbers::pi, 0};
    ring.nodes = {32, 1};
    whole.cloth.push_back(ring);
  }
  Simulation<2> simulation(whole, Parallel());
  const double polygon = 16 * 0.01 * std::sin(std::numbers::pi / 16);
  EXPECT_NEAR(Observer<2>(simulation).observe().enclosed_area, polygon, 1e-15);
}

/// A stream from the left drags a post along with it; nothing pushes it up or down.
TEST(Observer, StreamPushesThePost) {
  Case whole = box();
  whole.fluid.density = 1;
  whole.fluid.viscosity = 0.05;
  whole.fluid.velocity = {"1", "0", "0"};
  whole.domain.sides[0] = {SideKind::inflow, {1, 0, 0}};
  whole.domain.sides[1].kind = SideKind::outflow;
  whole.domain.sides[2].kind = whole.domain.sides[3].kind = SideKind::slip;
  whole.solids = {{"post", sphere({0.5, 0.5, 0}, 0.15), Vec<3>::Zero(), at_rest()}};
  Simulation<2> simulation(whole, Parallel());
  while (simulation.time() < 0.3) simulation.step(0.3);
  const Vec<3> force = Observer<2>(simulation).observe().solids[0].force;
  EXPECT_GT(force[0], 0.3);  // of 1/2 rho U^2 2 r = 0.15, at Re 6 and half blocked
  EXPECT_LT(force[0], 3);
  EXPECT_NEAR(force[1], 0, 1e-3 * force[0]);
  EXPECT_EQ(force[2], 0);
}

/// Cloth at rest in still water: what moves is round-off, whose ratios mean nothing.
TEST(Observer, SlipIsNoShareOfStillWater) {
  Case whole = box();
  whole.cloth = {thread()};
  whole.cloth[0].origin = {0.3, 0.5, 0};
  whole.time.step = 0.01;
  Simulation<2> simulation(whole, Parallel());
  Observer<2> observer(simulation);
  for (int s = 0; s < 5; ++s) observer.watch(simulation.step(1));
  EXPECT_LE(observer.extremes().speed, 1e-10);
  EXPECT_LE(observer.extremes().slip_share, 1e-3);
}

/// Slips are measured by the step's own speed, and by the run's while the water has come to rest.
TEST(Observer, SlipIsAShareOfTheSpeed) {
  const Case whole = box();
  Simulation<2> simulation(whole, Parallel());
  Observer<2> observer(simulation);
  Simulation<2>::Step step{};
  const auto watch = [&](double speed, double slip) {
    step.speed = speed;
    step.cloth.slip = slip;
    step.cloth.looked = true;
    observer.watch(step);
    return observer.extremes();
  };
  EXPECT_DOUBLE_EQ(watch(2, 0.1).slip_share, 0.05);
  EXPECT_DOUBLE_EQ(watch(1e-9, 1e-8).slip_share, 0.05);
  EXPECT_DOUBLE_EQ(watch(1, 0.2).slip_share, 0.2);
  EXPECT_NEAR(observer.extremes().sum_of_slip_shares, 0.25, 1e-6);
}

}  // namespace
}  // namespace washtub
