#include "solid/solid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "samples.hpp"

namespace washtub {
namespace {

/// An off-axis ball turning at 2 rad/s about the vertical through (1, 2, 0).
Solid turning_ball() { return {"ball", sphere({0.5, 0, 0.1}, 0.2), {1, 2, 0}, constant_speed(2)}; }

TEST(Solid, MatterIsCarriedByTheRotation) {
  const Solid ball = turning_ball();
  for (const double t : {0.0, 0.4, 3.0}) {
    const Vec<3> there(1 + 0.5 * std::cos(2 * t), 2 + 0.5 * std::sin(2 * t), 0.1);
    EXPECT_NEAR(ball.psi(there, t), 0.2, 1e-14);
    EXPECT_NEAR(ball.psi(there + Vec<3>(0, 0, 1), t), -0.8, 1e-14);
  }
}

TEST(Solid, PsiIsConstantAlongThePathOfItsMatter) {
  const Solid ball = turning_ball();
  Points points(1);
  const double t = 0.7, dt = 1e-5;
  for (int i = 0; i < 50; ++i) {
    const Vec<3> x = points.next(), u = ball.velocity(x, t);
    EXPECT_NEAR(ball.psi(x + dt * u, t + dt), ball.psi(x - dt * u, t - dt), 1e-10);
  }
}

TEST(Solid, VelocityIsThatOfRigidRotation) {
  const Vec<3> u = turning_ball().velocity({1.5, 2.25, 7}, 0.3);
  EXPECT_TRUE(u.isApprox(Vec<3>(-0.5, 1.0, 0)));
}

TEST(Solid, NormalPointsIntoTheSolid) {
  const Solid ball = turning_ball();
  const Vec<3> centre(1.5, 2, 0.1), away(0.6, 0, 0.8);
  EXPECT_TRUE(ball.normal(centre + 0.3 * away, 0, 1e-4).isApprox(-away, 1e-6));
  EXPECT_EQ(ball.normal(centre, 0, 1e-4).norm(), 0);
}

TEST(Solid, PoseAgreesWithTheSolid) {
  const Solid ball = turning_ball();
  const SolidPose pose = ball.at(1.3);
  Points points(1);
  for (int i = 0; i < 20; ++i) {
    const Vec<3> x = points.next();
    EXPECT_EQ(pose.psi(x), ball.psi(x, 1.3));
    EXPECT_EQ(pose.velocity(x), ball.velocity(x, 1.3));
  }
}

}  // namespace
}  // namespace washtub
