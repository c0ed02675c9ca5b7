#include "measure/persistence.hpp"

#include <gtest/gtest.h>

#include "base/snapshot.hpp"

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

/// Going back to an earlier instant it knows what it knew then.
TEST(Persistence, IsKeptWithTheRest) {
  Persistence persistence(1);
  persistence.add(0, {{0, 1}, {2, 3}});
  Snapshot then;
  then.take(persistence);
  persistence.add(0.5, {{4, 5}});
  persistence.add(1, {{0, 1}, {2, 3}});
  EXPECT_DOUBLE_EQ(persistence.share(), 1);
  then.put_back(persistence);
  EXPECT_TRUE(std::isnan(persistence.share()));
  persistence.add(1, {{2, 3}});
  EXPECT_DOUBLE_EQ(persistence.share(), 0.5);
}

TEST(Persistence, KeepsNothingWithoutASpan) {
  Persistence persistence;
  persistence.add(0, {{0, 1}});
  persistence.add(0, {{0, 1}});
  EXPECT_TRUE(std::isnan(persistence.share()));
}
