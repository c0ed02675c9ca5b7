#include "measure/trajectory.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "measure/scatter.hpp"

namespace washtub {
namespace {

using std::numbers::pi;

struct Track {
  std::vector<double> times;
  std::vector<Vec<2>> points;
};

/// `turns` times round a circle in (r, z), counter-clockwise if positive, 400 samples.
Track circle(const Vec<2>& centre, double radius, double turns) {
  Track t;
  for (int i = 0; i <= 400; ++i) {
    const double a = 2 * pi * turns * i / 400;
    t.times.push_back(0.01 * i);
    t.points.push_back(centre + radius * Vec<2>(std::cos(a), std::sin(a)));
  }
  return t;
}

TEST(Trajectory, CentreOfMassHalvesTheBorder) {
  const std::vector<Vec<3>> points = {{0, 0, 0}, {1, 0, 2}, {4, 0, 0}};
  const std::vector<double> area = {0.5, 1, 0.5};
  EXPECT_TRUE(centre_of_mass<3>(points, area).isApprox(Vec<3>(1.5, 0, 1)));
}

TEST(Trajectory, RadiusIsMeasuredFromTheAxis) {
  EXPECT_TRUE(radius_height<3>({4, 6, 7}, {1, 2}).isApprox(Vec<2>(5, 7)));
  EXPECT_TRUE(radius_height<2>({4, 6}, {1, 2}).isApprox(Vec<2>(5, 0)));
}

TEST(Trajectory, MeanPositionWeighsByTime) {
  const std::vector<double> times = {0, 1, 4};
  const std::vector<Vec<2>> track = {{0, 0}, {2, 0}, {2, 4}};
  EXPECT_TRUE(mean_position(times, track).isApprox(Vec<2>(7.0 / 4, 6.0 / 4)));
}

TEST(Loop, CircleSweepsItsAreaEachTurn) {
  const Track t = circle({0.2, 0.1}, 0.05, 2);
  const Loop l = loop(t.times, t.points);
  EXPECT_NEAR(l.turns, 2, 1e-12);
  EXPECT_NEAR(l.area, 2 * pi * 0.05 * 0.05, 1e-5);
  EXPECT_TRUE(l.centre.isApprox(Vec<2>(0.2, 0.1), 1e-9));
  const Track back = circle({0.2, 0.1}, 0.05, -1);
  EXPECT_NEAR(loop(back.times, back.points).turns, -1, 1e-12);
}

TEST(VelocityMap, TellsTheLoopOfTheWashFromItsReverse) {
  for (const double sense : {1.0, -1.0}) {
    const Track t = circle({0.6, 0.5}, 0.4, sense);
    VelocityMap map(1, 1);
    map.add(t.times, t.points);
    EXPECT_EQ(map.agreeing(), sense > 0 ? 4 : 0);
    EXPECT_GT(sense * map.wall_rise().mean(), 0.3);
    EXPECT_LT(sense * map.top_outward().mean(), -0.3);
  }
}

TEST(VelocityMap, UnvisitedRegionsDoNotAgree) {
  VelocityMap map(1, 1);
  map.add(std::vector<double>{0, 2}, std::vector<Vec<2>>{{0.9, 0.4}, {0.9, 0.6}});
  EXPECT_EQ(map.agreeing(), 1);
  EXPECT_DOUBLE_EQ(map.wall_rise().mean(), 0.1);
}

TEST(Scatter, PiecesAtRestScatterByTheirPlacesAndExtent) {
  Scatter s(2, {0, 1}, {1, 1});
  const std::vector<double> area = {1, 1};
  const std::vector<Vec<3>> low = {{2, 1, 0}, {4, 1, 0}}, high = {{1, 3, 6}, {1, 5, 6}};
  s.add<3>({0, 1}, 0, low, area);
  s.add<3>({0, 1}, 1, high, area);
  EXPECT_TRUE(s.centre(1).isApprox(Vec<2>(3, 6)));
  EXPECT_TRUE(s.centre().isApprox(Vec<2>(2.5, 3)));
  EXPECT_DOUBLE_EQ(s.own(), 1);
  EXPECT_DOUBLE_EQ(s.common(), std::sqrt(1 + 0.25 + 9));
}

/// Cloth that wanders off: about its own centre each half sees less of it than the whole window.
TEST(Scatter, OfHalvesAboutTheWholeCentreMakesUpTheWhole) {
  Scatter whole(1, {0, 2}, {0, 0});
  std::array<Scatter, 2> half = {Scatter(1, {0, 1}, {0, 0}), Scatter(1, {1, 2}, {0, 0})};
  const std::vector<double> area = {1, 1};
  for (int i = 0; i < 8; ++i) {
    const std::vector<Vec<3>> points = {{1.0 + i, 0, 0}, {1.5 + i, 0, 0.1 * i * i}};
    for (Scatter* s : {&whole, &half[0], &half[1]})
      s->add<3>({0.25 * i, 0.25 * (i + 1)}, 0, points, area);
  }
  const auto mean = [&](auto part) {
    return std::sqrt((std::pow((half[0].*part)(whole), 2) + std::pow((half[1].*part)(whole), 2)) /
                     2);
  };
  EXPECT_NEAR(mean(&Scatter::common_about), whole.common(), 1e-12);
  EXPECT_NEAR(mean(&Scatter::own_about), whole.own(), 1e-12);
  EXPECT_LT(half[0].own(), half[0].own_about(whole));
}

TEST(Scatter, MotionCountsWithinTheWindowOnly) {
  Scatter s(1, {0, 2}, {0, 0});
  const std::vector<double> area = {1};
  s.add<2>({-1, 0}, 0, std::vector<Vec<2>>{{99, 0}}, area);
  s.add<2>({0, 1}, 0, std::vector<Vec<2>>{{1, 0}}, area);
  s.add<2>({1, 5}, 0, std::vector<Vec<2>>{{0, 3}}, area);
  EXPECT_DOUBLE_EQ(s.own(), 1);
  EXPECT_DOUBLE_EQ(s.common(), 1);
}

}  // namespace
}  // namespace washtub
