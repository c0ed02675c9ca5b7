#include "contact/filter.hpp"

#include <gtest/gtest.h>

#include "cloth/crossings.hpp"
#include "contact/heap.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

/// A heap whose nodes try to go many gaps far in any direction, step after step.
template <int D>
void expect_no_crossing() {
  auto cloth = heap<D>(6, 0.02);
  const ClothSurface<D> surface(cloth);
  PairList<D> list(surface, open_box<D>(), 0.02, Share(Parallel()));
  CrossingFilter<D> filter(surface, Parallel());
  int cut = 0;
  for (std::uint64_t step = 0; step < 40; ++step) {
    const auto ways = random_ways<D>(cloth.position.size(), 0.05, step);
    auto Y = cloth.position;
    for (std::size_t i = 0; i < Y.size(); ++i) Y[i] += ways[i];
    cut += filter.cut(list, cloth.position, Y);
    cloth.position = Y;
    const auto found = find_crossings(cloth, open_box<D>());
    ASSERT_EQ(found.others + found.own, 0) << step;
    ASSERT_GT(least_gap(surface, Y), 0);
  }
  EXPECT_GT(cut, 40);
}

/// How far in the same steps without a filter edges have crossed.
template <int D>
long crossings_without() {
  auto cloth = heap<D>(6, 0.02);
  for (std::uint64_t step = 0; step < 40; ++step) {
    const auto ways = random_ways<D>(cloth.position.size(), 0.05, step);
    for (std::size_t i = 0; i < ways.size(); ++i) cloth.position[i] += ways[i];
  }
  return find_crossings(cloth, open_box<D>()).others;
}

}  // namespace

TEST(CrossingFilter, LetsNothingCross) {
  expect_no_crossing<2>();
  expect_no_crossing<3>();
  EXPECT_GT(crossings_without<2>(), 5);
  EXPECT_GT(crossings_without<3>(), 5);
}

TEST(CrossingFilter, LeavesPiecesAloneThatDoNotMeet) {
  const auto cloth = heap<3>(4, 0.02);
  const ClothSurface<3> surface(cloth);
  PairList<3> list(surface, open_box<3>(), 0.02, Share(Parallel()));
  CrossingFilter<3> filter(surface, Parallel());
  auto Y = cloth.position;
  for (auto& y : Y) y += Vec<3>(30, 20, 10);  // all together, far beyond the gaps
  const auto asked = Y;
  EXPECT_EQ(filter.cut(list, cloth.position, Y), 0);
  EXPECT_EQ(Y, asked);
  EXPECT_EQ(filter.shortest(), 1);
}

TEST(CrossingFilter, CutsOnlyPiecesThatMeet) {
  const auto cloth = heap<3>(3, 0.1);
  const ClothSurface<3> surface(cloth);
  PairList<3> list(surface, open_box<3>(), 0.02, Share(Parallel()));
  CrossingFilter<3> filter(surface, Parallel());
  auto Y = cloth.position;
  for (std::size_t i = 0; i < 20; ++i) Y[i][2] += 0.5;  // the lowest goes through the second
  for (std::size_t i = 40; i < 60; ++i) Y[i][2] += 0.5;
  const auto asked = Y;
  EXPECT_EQ(filter.cut(list, cloth.position, Y), 2);
  for (std::size_t i = 40; i < 60; ++i) EXPECT_EQ(Y[i], asked[i]);
  EXPECT_LT(Y[0][2], 0.1);
  EXPECT_GT(Y[0][2], 0.05);
}
