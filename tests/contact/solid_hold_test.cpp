#include "contact/solid_hold.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "support/dots.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double h = 1.0 / 16, k = 100, dt = 1e-3;

/// A node in a closed box, drawn step after step to where nothing but the stiffness k of its way
/// within the step holds it.
struct Sled {
  Grid<2> grid{{{0, 0}, {h, h}, {16, 16}}, Parallel(), {1, 1}};
  DomainMapping<2> mapping;
  Cloth<2> cloth;
  Barrier<2> barrier;
  SolidHold<2> hold;
  double time = 0;
  Vec<2> reaction = Vec<2>::Zero();

  explicit Sled(double friction, const Vec<2>& start = {0.5, 0.5 * h},
                const std::vector<Solid>& solids = {})
      : mapping(grid, solids),
        cloth(dots<2>({start})),
        barrier(grid, mapping, cloth, 0),
        hold(barrier, {friction}) {
    mapping.update(0);
  }

  Vec<2>& x() { return cloth.position[0]; }

  void step(const Vec<2>& pull) {
    mapping.update(time += dt);
    const std::vector<Mat<2>> yield = {Mat<2>::Identity() / k};
    const Vec<2> free = x() + pull / k;
    std::vector<Vec<2>> next = {free}, push = {Vec<2>::Zero()};
    std::vector<char> pushed(1);
    hold.start();
    for (int round = 0; round < 8; ++round) {
      pushed[0] = 0;
      HeldStep<2> held{dt, cloth.position, next, yield, push, pushed};
      hold.hold(held);
      if (!pushed[0]) break;
      Mat<2> K = k * Mat<2>::Identity();
      Vec<2> to = k * free;
      hold.add(0, K, to);
      next[0] = K.inverse() * to;
    }
    hold.end(next);
    reaction.setZero();
    hold.for_forces([&](int, int, const Vec<2>& f) { reaction += f; });
    barrier.accept(next, dt);
    cloth.position = next;
  }
};

}  // namespace

TEST(SolidHold, CarriesWhatPressesOnIt) {
  Sled sled(0);
  for (int i = 0; i < 10; ++i) sled.step({0, -2});
  EXPECT_NEAR(sled.reaction[1], 2, 1e-3);
  EXPECT_NEAR(sled.x()[1], 0.5 * h, 1e-3 * h);
  sled.step({0, 1});  // it lets go at once
  EXPECT_EQ(sled.reaction, Vec<2>(0, 0));
  EXPECT_NEAR(sled.x()[1], 0.5 * h + 1 / k, 1e-3 * h);
}

/// What is drawn away by others in the course of a step is let go in that step.
TEST(SolidHold, DoesNotPull) {
  Sled sled(0);
  const std::vector<Mat<2>> yield = {Mat<2>::Identity() / k};
  std::vector<Vec<2>> next = {{0.5, 0}}, push = {Vec<2>::Zero()};
  std::vector<char> pushed(1);
  HeldStep<2> held{dt, sled.cloth.position, next, yield, push, pushed};
  sled.hold.start();
  sled.hold.hold(held);
  EXPECT_EQ(sled.hold.count(), 1);
  next[0][1] = 2 * h;
  sled.hold.hold(held);
  EXPECT_EQ(sled.hold.count(), 0);
}

TEST(SolidHold, LetsSlideWithoutFriction) {
  Sled sled(0);
  for (int i = 0; i < 10; ++i) sled.step({0.5, -2});
  EXPECT_NEAR(sled.x()[0], 0.5 + 10 * 0.5 / k, 1e-9);
  EXPECT_EQ(sled.reaction[0], 0);
}

/// Below the angle of friction nothing moves, in a minute of steps as in one; above it, friction is
/// Coulomb's.
TEST(SolidHold, SticksBelowTheAngleOfFrictionAndSlidesAbove) {
  Sled sled(0.3);
  sled.step({0.55, -2});
  const double start = sled.x()[0];
  for (int i = 0; i < 60000; ++i) sled.step({0.55, -2});
  EXPECT_NEAR(sled.x()[0], start, 1e-9);
  EXPECT_NEAR(sled.reaction[0], -0.55, 1e-3);
  for (int i = 0; i < 10; ++i) sled.step({0.65, -2});
  EXPECT_NEAR(sled.reaction[0], -0.6, 2e-3);
  EXPECT_NEAR(sled.x()[0] - start, 10 * 0.05 / k, 2e-4);
  for (int i = 0; i < 10; ++i) sled.step({-0.65, -2});  // friction turns with the motion
  EXPECT_NEAR(sled.reaction[0], 0.6, 2e-3);
  EXPECT_NEAR(sled.x()[0], start, 2e-4);
  sled.step({0.1, -2});
  EXPECT_NEAR(sled.reaction[0], -0.1, 2e-3);
}

/// On a turning drum a node that sticks goes along with it, one without friction stays behind.
TEST(SolidHold, IsCarriedByASurfaceThatMoves) {
  constexpr double inf = std::numeric_limits<double>::infinity(), speed = 2;
  const Vec<2> centre(0.5, 0.5);
  const Solid drum{"drum", cylinder(0.2, -inf, inf), {0.5, 0.5, 0}, constant_speed(speed)};
  for (const double friction : {0.0, 5.0}) {
    Sled sled(friction, {0.5, 0.7 + 0.5 * h}, {drum});
    for (int i = 0; i < 100; ++i) sled.step(centre - sled.x());
    const Vec<2> arm = sled.x() - centre;
    EXPECT_NEAR(std::atan2(-arm[0], arm[1]), friction > 0 ? speed * 0.1 : 0, 2e-3) << friction;
    EXPECT_NEAR(arm.norm(), 0.2 + 0.5 * h, 0.02 * h);
  }
}

/// Pressed against the side of a fin, a node that sticks goes round with it for two turns without
/// creeping outwards.
TEST(SolidHold, StaysWhereItIsOnAFinThatTurns) {
  constexpr double speed = 10;
  const Vec<2> centre(0.5, 0.5);
  const Solid fin{
      "fin", box({-0.4, -0.04, -1}, {0.4, 0.04, 1}), {0.5, 0.5, 0}, constant_speed(speed)};
  Sled sled(5, {0.7, 0.54 + 0.5 * h}, {fin});
  const double radius = (sled.x() - centre).norm();
  const int steps = static_cast<int>(2 * 2 * std::numbers::pi / (speed * dt));
  for (int i = 0; i < steps; ++i) {
    const double angle = speed * dt * i;
    sled.step(5 * Vec<2>(std::sin(angle), -std::cos(angle)));
  }
  EXPECT_NEAR((sled.x() - centre).norm(), radius, 1e-3 * h);
}
