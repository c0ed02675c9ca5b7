#include "record/self_watch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cloth/thread.hpp"

namespace washtub {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// Water at rest between two walls, of which the upper one moves at 1 m/s.
Case channel() {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {16, 32, 1};
  whole.domain.sides[0] = whole.domain.sides[1] = {SideKind::periodic, Vec<3>::Zero()};
  whole.domain.sides[3] = {SideKind::moving_wall, {1, 0, 0}};
  whole.fluid = {.density = 1, .viscosity = 0.1};
  whole.time.end = 10;
  whole.time.step = 5e-3;
  whole.time.fixed = true;
  return whole;
}

/// The wall's work sets the water going and then becomes heat.
TEST(SelfWatch, FindsWhereTheWorkOfAWallGoes) {
  Simulation<2> simulation(channel(), Parallel());
  SelfWatch<2> watch(simulation);
  QualitySample last = watch.observe(0);
  while (simulation.time() < 10 - 1e-9) {
    simulation.step(10);
    last = watch.observe(0);
  }
  const auto& balance = watch.quality().balance;
  EXPECT_TRUE(is_closed(channel()));
  EXPECT_NEAR(balance.gain, 1.0 / 6, 1e-3);  // of u = y
  EXPECT_NEAR(last.dissipation, 0.1, 1e-3);
  EXPECT_LT(std::abs(balance.share()), 0.02);
  EXPECT_LT(std::abs(last.residual), 1e-3 * 0.1);
  EXPECT_NEAR(watch.quality().worst.driving_speed, 1, 1e-12);
  EXPECT_LE(watch.quality().worst.speed_ratio(), 1);
  EXPECT_LT(watch.quality().worst.grid_scale, Resolution::grid_scale_bound);
  EXPECT_FALSE(watch.first_alarm());
}

TEST(SelfWatch, KeepsNoBalanceWhereWaterPasses) {
  Case whole = channel();
  whole.domain.sides[0] = {SideKind::inflow, {1, 0, 0}};
  whole.domain.sides[1] = {SideKind::outflow, Vec<3>::Zero()};
  whole.domain.sides[3] = {};
  Simulation<2> simulation(whole, Parallel());
  SelfWatch<2> watch(simulation);
  watch.observe(0);
  simulation.step(1);
  EXPECT_EQ(watch.observe(0).residual, 0);
  EXPECT_FALSE(is_closed(whole));
  EXPECT_EQ(watch.quality().balance.time, 0);
}

/// Noise is told once.
TEST(SelfWatch, TellsOfAnUnresolvedFlowOnce) {
  Case whole = channel();
  whole.domain.sides[3] = {};
  whole.fluid.viscosity = 1e-6;
  whole.fluid.velocity[0] = "sin(3.14159265 * 32 * y)";
  Simulation<2> simulation(whole, Parallel());
  SelfWatch<2> watch(simulation);
  EXPECT_GT(watch.observe(0).resolution.grid_scale, 0.9);
  EXPECT_THAT(watch.first_alarm().value_or(""), HasSubstr("The grid does not resolve this flow"));
  watch.observe(0);
  EXPECT_FALSE(watch.first_alarm());
}

TEST(SelfWatch, CountsCrossings) {
  Case whole = channel();
  ClothCase thread;
  thread.arrangement = Arrangement::sheet;
  thread.size = {0.4, 0};
  thread.nodes = {9, 1};
  thread.material = {100, 0, 1e-3, 0, 0, 0, 1e-3};
  thread.origin = {0.3, 0.51, 0};
  whole.cloth = {thread, thread};
  whole.cloth[1].origin = {0.52, 0.3, 0};
  whole.cloth[1].along[0] = Vec<3>::UnitY();
  whole.contact.scheme = ContactScheme::none;
  Simulation<2> simulation(whole, Parallel());
  SelfWatch<2> watch(simulation);
  watch.look_at_cloth();
  EXPECT_EQ(watch.quality().crossings.others, 2);
  EXPECT_EQ(watch.quality().most_crossings, 2);
  EXPECT_EQ(watch.quality().crossings.edges, 16);
}

/// A heavy thread falls: what its weight does is found in its motion and the water's.
TEST(SelfWatch, FindsWhereTheWorkOfAWeightGoes) {
  Case whole = channel();
  whole.domain.sides[3] = {};
  whole.fluid.gravity = {0, -1, 0};
  whole.time.step = 1e-3;
  ClothCase thread;
  thread.arrangement = Arrangement::sheet;
  thread.size = {0.4, 0};
  thread.nodes = {9, 1};
  thread.material = {100, 0, 1e-3, 0, 0, 0.5, 1e-3};
  thread.origin = {0.3, 0.7, 0};
  whole.cloth = {thread};
  Simulation<2> simulation(whole, Parallel());
  SelfWatch<2> watch(simulation);
  watch.observe(0);
  for (int i = 0; i < 200; ++i) {
    simulation.step(10);
    watch.observe(0);
  }
  const auto& balance = watch.quality().balance;
  EXPECT_GT(balance.work, 0);
  EXPECT_NEAR(balance.work, simulation.work_on_cloth(), 1e-9);
  EXPECT_LT(std::abs(balance.rest()), 0.1 * balance.work);
}

/// Drive, cloth and turning fins: the balance closes but for what the scheme takes.
TEST(VerificationSelfWatch, ClosesTheBalanceOfAWash) {
  const Case whole = read_case("cases/wash-3d/case.toml",
                               {"domain.cells=24", "cloth.count=4", "cloth.nodes=[5, 5]"});
  Simulation<3> simulation(whole, Parallel());
  SelfWatch<3> watch(simulation);
  watch.observe(0);
  while (simulation.time() < 0.2 - 1e-9) {
    simulation.step(0.2);
    double power = 0;
    for (std::size_t s = 0; s < simulation.mapping().solids().size(); ++s) {
      const Impulse i = simulation.take_impulse(s);
      if (i.time > 0) power -= i.moment * i.angle / (i.time * i.time);
    }
    watch.observe(power);
  }
  const auto& b = watch.quality().balance;
  EXPECT_GT(b.work, 0);
  EXPECT_GT(b.heat, 0.1 * b.work);
  EXPECT_LT(std::abs(b.share()), 0.15);
}

TEST(Quality, Warnings) {
  Case whole = channel();
  Quality quality;
  quality.crossings.edges = 5376;
  EXPECT_THAT(quality.warnings(whole), IsEmpty());
  quality.worst.grid_scale = 0.3;
  quality.balance = {.time = 1, .work = 10, .gain = 8, .heat = 5};
  quality.start = "The cloth still moved.";
  quality.most_crossings = 212;
  EXPECT_THAT(
      quality.warnings(whole),
      ElementsAre("The cloth still moved.",
                  HasSubstr("up to 30 % of the water's kinetic energy alternates"),
                  HasSubstr("The scheme put energy into the motion: 30 % of the work or the heat"),
                  HasSubstr("passes through other cloth: up to 212 of 5376 edges (3.9 %) in a "
                            "frame.")));
  whole.domain.sides[1].kind = SideKind::outflow;
  quality.worst = {};
  quality.start.clear();
  quality.most_crossings = 50;
  EXPECT_THAT(quality.warnings(whole),
              ElementsAre(HasSubstr("in a frame. Contact keeps apart what is not tangled")));
  whole.contact.scheme = ContactScheme::none;
  EXPECT_THAT(quality.warnings(whole), IsEmpty());
}

}  // namespace
}  // namespace washtub
