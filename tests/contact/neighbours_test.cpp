#include "contact/neighbours.hpp"

#include <gtest/gtest.h>

#include "contact/heap.hpp"

using namespace washtub;
using namespace washtub::testing;

/// Three plates on top of each other, 0.02 apart but for the last.
TEST(Neighbours, GapIsTheSmallestBetweenPieces) {
  auto cloth = heap<3>(3, 0.02);
  for (std::size_t i = 40; i < 60; ++i) cloth.position[i][2] += 0.1;
  const auto found = find_neighbours(cloth, open_box<3>(), 0.05);
  EXPECT_NEAR(found.gap, 0.02, 1e-12);
  EXPECT_EQ(found.own_gap, Neighbours::none);
  for (const auto& [a, b] : found.nodes) {
    EXPECT_LT(a, 20);
    EXPECT_GE(b, 20);
    EXPECT_LT(b, 40);
    EXPECT_LT(
        (cloth.position[static_cast<std::size_t>(a)] - cloth.position[static_cast<std::size_t>(b)])
            .norm(),
        0.05);
  }
  EXPECT_FALSE(found.nodes.empty());
  EXPECT_EQ(find_neighbours(cloth, open_box<3>(), 0.019).gap, Neighbours::none);
}

TEST(Neighbours, NodesAreEveryPairWithinReach) {
  const auto cloth = heap<2>(4, 0.03);
  const auto found = find_neighbours(cloth, open_box<2>(), 0.07);
  std::vector<std::pair<int, int>> all;
  for (int a = 0; a < 24; ++a)
    for (int b = a + 1; b < 24; ++b)
      if (a / 6 != b / 6 && (cloth.position[static_cast<std::size_t>(a)] -
                             cloth.position[static_cast<std::size_t>(b)])
                                    .norm() < 0.07)
        all.emplace_back(a, b);
  EXPECT_EQ(found.nodes, all);
}

/// A thread folded back on itself: its ends are near, though far apart along it.
TEST(Neighbours, OwnGapIsThatOfAFold) {
  auto cloth = heap<2>(1, 0.1);
  cloth.position = {{0, 0}, {0.1, 0}, {0.2, 0}, {0.2, 0.02}, {0.1, 0.02}, {0, 0.02}};
  const auto found = find_neighbours(cloth, open_box<2>(), 0.05);
  EXPECT_NEAR(found.own_gap, 0.02, 1e-12);
  EXPECT_TRUE(found.nodes.empty());
}
