#include "measure/cloth_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/snapshot.hpp"

namespace washtub {
namespace {

/// Rows every `every` [s] up to `end` of one piece whose stress and place are the time.
ClothStatistics collected(const Interval& window, double period, double end, double every = 0.25) {
  ClothStatistics statistics(1, window, period, {0, 0});
  const std::vector<double> area = {1};
  for (int i = 1; i * every <= end + 1e-9; ++i) {
    const double t = i * every;
    const std::vector<StressParts> stress = {{0, 0, t}};
    const std::vector<Vec<2>> place = {{t, 0}};
    statistics.add({t - every, t}, [&](ClothStatistics::Part& part) {
      part.stress.add({t - every, t}, stress);
      part.scatter.add<2>({t - every, t}, 0, place, area);
    });
  }
  return statistics;
}

TEST(ClothStatistics, WholeCyclesThatHaveEnded) {
  const ClothStatistics s = collected({1, 4.75}, 1, 3.5);  // two cycles, and half a third
  EXPECT_NEAR(s.all().stress.total().mean, 2.125, 1e-12);
  EXPECT_NEAR(s.all().scatter.centre()[0], 2.125, 1e-12);
  ASSERT_EQ(s.cycles().size(), 2U);
  EXPECT_NEAR(s.cycles()[1].centre()[0], 2.625, 1e-12);
  EXPECT_NEAR(s.all().stress.time(), 2, 1e-12);
}

TEST(ClothStatistics, AllThereIsWithoutAWholeCycle) {
  EXPECT_NEAR(collected({1, 4.75}, 1, 1.5).all().stress.total().mean, 1.375, 1e-12);
  const ClothStatistics none = collected({1, 1.75}, 1, 4);  // nor would the window hold one
  EXPECT_NEAR(none.all().stress.total().mean, 1.5, 1e-12);
  EXPECT_TRUE(none.cycles().empty());
  EXPECT_TRUE(std::isnan(collected({1, 3}, 1, 0.5).all().stress.total().mean));
}

TEST(ClothStatistics, WithoutAPeriodEighthsAndWhatComesAfterThem) {
  const ClothStatistics s = collected({0, 8}, 0, 2.5);
  EXPECT_EQ(s.cycles().size(), 2U);
  EXPECT_NEAR(s.all().stress.total().mean, 1.375, 1e-12);
}

/// What was interrupted within the second cycle goes on as if it had not been.
TEST(ClothStatistics, GoesOnFromItsState) {
  ClothStatistics whole = collected({1, 4}, 1, 3.75), before = collected({1, 4}, 1, 2.5);
  Snapshot snapshot;
  snapshot.take(before);
  ClothStatistics again = collected({1, 4}, 1, 1.75);
  snapshot.put_back(again);
  for (ClothStatistics* s : {&whole, &again}) {
    const double from = s == &whole ? 3.75 : 2.5;
    s->add({from, 4}, [&](ClothStatistics::Part& part) {
      part.stress.add({from, 4}, std::vector<StressParts>{{0, 0, 9}});
    });
  }
  EXPECT_EQ(again.cycles().size(), 3U);
  EXPECT_NEAR(again.cycles()[0].centre()[0], whole.cycles()[0].centre()[0], 1e-15);
  EXPECT_NEAR(again.all().stress.time(), 3, 1e-12);
  const double expected = (1.625 + (2.25 + 2.5) / 4 + 9 * 1.5) / 3;
  EXPECT_NEAR(again.all().stress.total().mean, expected, 1e-12);
}

/// A row across the end of a cycle counts in both with its share.
TEST(ClothStatistics, RowsNeedNotMeetTheCycles) {
  const ClothStatistics s = collected({1, 3}, 1, 3.3, 0.3);
  const double first = (0.2 * 1.2 + 0.3 * 1.5 + 0.3 * 1.8 + 0.2 * 2.1) / 1;
  ASSERT_EQ(s.cycles().size(), 2U);
  EXPECT_NEAR(s.cycles()[0].centre()[0], first, 1e-12);
  EXPECT_NEAR(s.all().stress.time(), 2, 1e-12);
}

}  // namespace
}  // namespace washtub
