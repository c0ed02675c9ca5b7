#include "measure/rainflow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/snapshot.hpp"

namespace washtub {
namespace {

using Counts = Rainflow::Counts;

/// The example of ASTM E1049-85, Fig. 6, a hundred times smaller. By the standard's table: ranges
/// of 3 (half a cycle), 4 (one and a half), 6 (half), 8 (one) and 9 (half).
TEST(Rainflow, ExampleOfTheStandard) {
  Rainflow flow(1);
  for (const double x : {-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0}) flow.add(0, 0.01 * x);
  EXPECT_EQ(flow.counts(), (Counts{4, 4, 2}));
}

/// A small cycle that interrupts a large one does not cut it in two.
TEST(Rainflow, LargeCyclesAreSeenThroughSmallOnes) {
  Rainflow flow(2);
  for (int i = 0; i <= 2000; ++i) {
    const double t = 2 * std::numbers::pi * i / 200;  // ten periods
    flow.add(0, 0.03 * std::sin(t) + 0.003 * std::sin(20 * t));
    flow.add(1, 0.004 * std::sin(t));
  }
  const Counts counts = flow.counts();
  EXPECT_NEAR(counts[2], 10, 0.5);             // the large ones
  EXPECT_NEAR(counts[1], 10, 0.5);             // again, and none of the second signal's 0.008
  EXPECT_NEAR(counts[0], 10 * 20 + 10, 10.5);  // the small ones, but for one a period or none
}

/// Each swing counts once it is there, whatever comes after it.
TEST(Rainflow, SwingsThatDieAwayCount) {
  Rainflow flow(1);
  for (int i = 0; i < 40; ++i) flow.add(0, (i % 2 ? -1 : 1) * 0.03 * std::pow(0.9, i));
  const auto swings = [](double bound) {  // 0.03 * 0.9^i * 1.9 of the i-th
    return std::floor(std::log(bound / (0.03 * 1.9)) / std::log(0.9)) + 1;
  };
  EXPECT_EQ(flow.counts(), (Counts{0.5 * swings(0.001), 0.5 * swings(0.01), 0.5 * swings(0.05)}));
}

TEST(Rainflow, StandingStillIsNoCycle) {
  Rainflow flow(1);
  for (const double x : {0.1, 0.1, 0.1005, 0.1, 0.1, 0.0995, 0.0996}) flow.add(0, x);
  EXPECT_EQ(flow.counts(), (Counts{0.5, 0, 0}));  // from 0.1005 to 0.0995
}

TEST(Rainflow, GoesOnAsItWas) {
  const auto signal = [](int i) { return 0.02 * std::sin(0.3 * i) + 0.01 * std::cos(1.7 * i); };
  Rainflow whole(1), part(1);
  for (int i = 0; i < 100; ++i) whole.add(0, signal(i));
  for (int i = 0; i < 40; ++i) part.add(0, signal(i));
  Snapshot snapshot;
  snapshot.take(part);
  Rainflow later(1);
  for (int i = 0; i < 7; ++i) later.add(0, signal(3 * i));
  snapshot.put_back(later);
  for (int i = 40; i < 100; ++i) later.add(0, signal(i));
  EXPECT_EQ(later.counts(), whole.counts());
  EXPECT_EQ(later.take(), whole.counts());
  EXPECT_EQ(later.take(), (Counts{0, 0, 0}));
}

}  // namespace
}  // namespace washtub
