#include "contact/start_check.hpp"

#include <gtest/gtest.h>

#include "contact/heap.hpp"

using namespace washtub;
using namespace washtub::testing;

TEST(StartCheck, NamesTheNearestPair) {
  auto cloth = heap<3>(4, 0.02);
  EXPECT_FALSE(find_too_near(cloth, open_box<3>(), 0.019));
  for (std::size_t i = 60; i < 80; ++i) cloth.position[i][2] -= 0.013;
  const auto found = find_too_near(cloth, open_box<3>(), 0.019);
  ASSERT_TRUE(found);
  EXPECT_EQ(std::minmax(found->first, found->second), std::minmax(2, 3));
  EXPECT_NEAR(found->distance, 0.007, 1e-12);
}

TEST(StartCheck, SeesWhatPassesThrough) {
  auto cloth = heap<2>(3, 0.05);
  cloth.position[7][1] -= 0.08;  // a node of the second thread, below the first
  const auto found = find_too_near(cloth, open_box<2>(), 1e-6);
  ASSERT_TRUE(found);
  EXPECT_EQ(std::minmax(found->first, found->second), std::minmax(0, 1));
  EXPECT_EQ(found->distance, 0);
}
