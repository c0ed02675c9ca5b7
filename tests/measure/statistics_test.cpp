#include "measure/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace washtub {
namespace {

TEST(Interval, OverlapIsTheSharedTime) {
  const Interval window{1, 3};
  EXPECT_DOUBLE_EQ(window.overlap({0, 1.5}), 0.5);
  EXPECT_DOUBLE_EQ(window.overlap({1.5, 2}), 0.5);
  EXPECT_DOUBLE_EQ(window.overlap({0, 9}), 2);
  EXPECT_DOUBLE_EQ(window.overlap({3, 4}), 0);
}

TEST(Statistics, WeightsCountAsRepetitions) {
  Statistics weighted, repeated;
  weighted.add(2, 3);
  weighted.add(-1, 1);
  weighted.add(100, 0);
  for (const double v : {2.0, 2.0, 2.0, -1.0}) repeated.add(v);
  EXPECT_DOUBLE_EQ(weighted.mean(), 1.25);
  EXPECT_DOUBLE_EQ(weighted.rms(), std::sqrt(13.0 / 4));
  EXPECT_DOUBLE_EQ(weighted.deviation(), std::sqrt(13.0 / 4 - 1.25 * 1.25));
  EXPECT_DOUBLE_EQ(repeated.deviation(), weighted.deviation());
}

TEST(Statistics, JoinedTheyKnowAllValues) {
  Statistics first, second, all;
  for (const double v : {3.0, 5.0, -2.0}) first.add(v, 2), all.add(v, 2);
  for (const double v : {100.0, 101.0}) second.add(v, 0.5), all.add(v, 0.5);
  Statistics joined;
  joined.add(first);
  joined.add(Statistics());
  joined.add(second);
  EXPECT_DOUBLE_EQ(joined.weight(), all.weight());
  EXPECT_DOUBLE_EQ(joined.mean(), all.mean());
  EXPECT_DOUBLE_EQ(joined.deviation(), all.deviation());
}

TEST(Statistics, SmallSpreadAboutALargeMeanIsNotLost) {
  Statistics s;
  for (const double v : {1e9 + 1, 1e9 - 1}) s.add(v);
  EXPECT_DOUBLE_EQ(s.deviation(), 1);
}

TEST(Statistics, NothingKnownBeforeTheFirstSample) {
  EXPECT_TRUE(std::isnan(Statistics().mean()) && std::isnan(Statistics().deviation()));
}

}  // namespace
}  // namespace washtub
