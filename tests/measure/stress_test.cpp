#include "measure/stress.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace washtub {
namespace {

TEST(Stress, AreaMeanHalvesTheBorder) {
  const std::vector<double> membrane = {1, 2, 3}, bending = {0, 4, 0}, total = {1, 6, 3};
  const StressParts mean = area_mean({membrane, bending, total}, std::vector<double>{1, 2, 1});
  EXPECT_DOUBLE_EQ(mean.membrane, 2);
  EXPECT_DOUBLE_EQ(mean.bending, 2);
  EXPECT_DOUBLE_EQ(mean.total, 4);
}

/// Two pieces, two samples of equal weight inside the window: (1, 5) and (3, 11) in total stress.
StressStatistics two_by_two() {
  StressStatistics s(2, {1, 3});
  s.add({0, 1}, std::vector<StressParts>{{9, 9, 99}, {9, 9, 99}});
  s.add({1, 2}, std::vector<StressParts>{{1, 0, 1}, {2, 3, 5}});
  s.add({2, 8}, std::vector<StressParts>{{1, 2, 3}, {2, 9, 11}});
  return s;
}

TEST(Stress, Equation15AndItsThreeDeviations) {
  const StressSummary total = two_by_two().total();
  EXPECT_DOUBLE_EQ(total.mean, 5);         // (2 + 8) / 2
  EXPECT_DOUBLE_EQ(total.over_time, 2);    // 3 and 7
  EXPECT_DOUBLE_EQ(total.over_pieces, 3);  // 2 and 8
  EXPECT_DOUBLE_EQ(total.over_time_pieces, std::sqrt((16 + 0 + 4 + 36) / 4.0));
  EXPECT_DOUBLE_EQ(two_by_two().time(), 2);
}

TEST(Stress, PartsAreKeptApart) {
  EXPECT_DOUBLE_EQ(two_by_two().membrane().mean, 1.5);
  EXPECT_DOUBLE_EQ(two_by_two().membrane().over_time, 0);
  EXPECT_DOUBLE_EQ(two_by_two().bending().mean, 3.5);
}

TEST(Stress, EmptyWindowIsUnknown) {
  EXPECT_TRUE(std::isnan(StressStatistics(3, {0, 1}).total().mean));
}

}  // namespace
}  // namespace washtub
