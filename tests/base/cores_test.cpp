#include "base/cores.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

using namespace washtub;
using ::testing::HasSubstr;

/// What one rank alone would do faster is not begun on several: no rank shares its core.
TEST(Cores, AreLeftToOthersWhereBusy) {
  EXPECT_EQ(free_ranks(2, 0), 2);
  EXPECT_EQ(free_ranks(2, 0.1), 2);
  EXPECT_EQ(free_ranks(2, 1), 1);
  EXPECT_EQ(free_ranks(2, 2), 1);
  EXPECT_EQ(free_ranks(8, 1.1), 7);
  EXPECT_EQ(free_ranks(8, 30), 1);
  EXPECT_EQ(free_ranks(1, 0), 1);
}

TEST(Cores, AreNoMoreBusyThanThereAre) {
  const double busy = busy_cores();
  EXPECT_GE(busy, 0);
  EXPECT_LE(busy, static_cast<double>(sysconf(_SC_NPROCESSORS_CONF)));
}

/// Who sleeps gets nothing of a core; time between pieces of work is left out.
TEST(Cores, AreSharedByTimeWorkedOverTimePassed) {
  CoreShare share;
  EXPECT_EQ(share.share(), 1);
  share.begin();
  usleep(50000);
  share.end();
  EXPECT_LT(share.share(), 0.5);
  const double before = share.share();
  usleep(50000);
  EXPECT_EQ(share.share(), before);
}

TEST(Cores, AreSaidToBeCrowdedWhereRanksWait) {
  EXPECT_FALSE(crowded(0.99, 2));
  EXPECT_FALSE(crowded(0.5, 1));
  EXPECT_THAT(crowded(0.5, 2).value_or(""), HasSubstr("gets 50 % of a core only"));
  EXPECT_THAT(crowded(0.5, 2).value_or(""), HasSubstr("try one rank (-n)"));
  EXPECT_THAT(crowded(0.5, 8).value_or(""), HasSubstr("try fewer ranks (-n)"));
}
