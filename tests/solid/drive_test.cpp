#include "solid/drive.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace washtub {
namespace {

using std::numbers::pi;

/// Midpoint rule with 20000 intervals.
double integral(const Drive& drive, double end) {
  const int n = 20000;
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += drive.speed((i + 0.5) * end / n);
  return sum * end / n;
}

TEST(Drive, AngleIsTheIntegralOfTheSpeed) {
  const std::vector<double> times = {0, 0.5, 0.7, 2}, speeds = {1, 3, -2, 0.5};
  for (const Drive& d : {at_rest(), constant_speed(-3), sinusoid(12, 0.6),
                         stroke_table(times, speeds, true), stroke_table(times, speeds, false)})
    for (const double t : {0.0, 0.3, 0.6, 1.9, 2.0, 5.3})
      EXPECT_NEAR(d.angle(t), integral(d, t), 2e-4 * (1 + std::abs(d.angle(t))));
}

TEST(Drive, ReferenceStrokeSweepsAFullTurnPerHalfPeriod) {
  const Drive d = sinusoid(120 * 2 * pi / 60, 2 / pi);
  EXPECT_NEAR(d.period(), 1.5708, 1e-4);
  EXPECT_NEAR(d.angle(d.period() / 2), 2 * pi, 1e-12);
  EXPECT_NEAR(d.angle(d.period()), 0, 1e-12);
}

TEST(Drive, TableIsLinearBetweenItsPoints) {
  const Drive held = stroke_table({0, 1, 3}, {0, 4, -2}, false);
  EXPECT_DOUBLE_EQ(held.speed(0.5), 2);
  EXPECT_DOUBLE_EQ(held.speed(2), 1);
  EXPECT_DOUBLE_EQ(held.speed(9), -2);
  EXPECT_DOUBLE_EQ(held.angle(5), 2 + 2 - 4);
  EXPECT_DOUBLE_EQ(held.peak(), 4);
  EXPECT_DOUBLE_EQ(held.period(), 0);
  const Drive again = stroke_table({0, 1, 3}, {0, 4, -2}, true);
  EXPECT_DOUBLE_EQ(again.speed(3.5), 2);
  EXPECT_DOUBLE_EQ(again.angle(6.5), 2 * 4 + 0.5);
  EXPECT_DOUBLE_EQ(again.period(), 3);
}

TEST(Drive, OnlyDrivesWithSpeedMove) {
  EXPECT_FALSE(at_rest().moving());
  EXPECT_TRUE(constant_speed(-1).moving());
  EXPECT_DOUBLE_EQ(sinusoid(-2, 1).peak(), 2);
}

TEST(Drive, ImpossibleTablesAreRefused) {
  using ::testing::HasSubstr;
  using ::testing::ThrowsMessage;
  const auto table = [](std::vector<double> t, std::vector<double> w) {
    return [t, w] { stroke_table(t, w, false); };
  };
  EXPECT_THAT(table({0, 1}, {1}), ThrowsMessage<InputError>(HasSubstr("2 times but 1 speeds")));
  EXPECT_THAT(table({0}, {1}), ThrowsMessage<InputError>(HasSubstr("at least two")));
  EXPECT_THAT(table({1, 2}, {1, 1}), ThrowsMessage<InputError>(HasSubstr("start at 1 s")));
  EXPECT_THAT(table({0, 1, 1}, {1, 1, 1}), ThrowsMessage<InputError>(HasSubstr("times[2]")));
  EXPECT_THAT(table({0, 1}, {NAN, 1}), ThrowsMessage<InputError>(HasSubstr("speeds = nan")));
  EXPECT_THAT([] { sinusoid(1, 0); }, ThrowsMessage<InputError>(HasSubstr("frequency = 0")));
}

}  // namespace
}  // namespace washtub
