#include "measure/persistence.hpp"

#include <gtest/gtest.h>

using namespace washtub;

/// Four pairs at first, of which one lasts; two more come a span later, and stay.
TEST(Persistence, IsTheShareOfPairsThatAreNearASpanLater) {
  Persistence persistence(1);
  const Persistence::Pairs first = {{0, 5}, {1, 6}, {2, 7}, {3, 8}};
  const Persistence::Pairs later = {{1, 6}, {4, 9}, {4, 10}};
  persistence.add(0, first);
  EXPECT_TRUE(std::isnan(persistence.share()));
  persistence.add(0.5, {});
  EXPECT_TRUE(std::isnan(persistence.share()));
  persistence.add(1, later);
  EXPECT_DOUBLE_EQ(persistence.share(), 1.0 / 4);
  persistence.add(1.5, later);
  EXPECT_DOUBLE_EQ(persistence.share(), 1.0 / 4);  // none were near at 0.5
  persistence.add(2.0, later);
  EXPECT_DOUBLE_EQ(persistence.share(), 4.0 / 7);
}

TEST(Persistence, SkipsInstantsThatMissTheSpan) {
  Persistence persistence(1);
  persistence.add(0, {{0, 1}});
  persistence.add(0.7, {{0, 1}});
  persistence.add(1.4, {{0, 1}});
  EXPECT_TRUE(std::isnan(persistence.share()));
}

TEST(Persistence, KeepsNothingWithoutASpan) {
  Persistence persistence;
  persistence.add(0, {{0, 1}});
  persistence.add(0, {{0, 1}});
  EXPECT_TRUE(std::isnan(persistence.share()));
}
