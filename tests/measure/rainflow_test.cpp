#include "measure/rainflow.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/snapshot.hpp"

namespace washtub {
namespace {

using Counts = Rainflow::Counts;

/// The example of ASTM E1049-85, Fig. 6, a hundred times smaller: but for the half cycles at its
/// ends, which do not count, one cycle of the range 4.
TEST(Rainflow, ExampleOfTheStandard) {
  Rainflow flow(1);
  for (const double x : {-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0}) flow.add(0, 0.01 * x);
  EXPECT_EQ(flow.counts(), (Counts{1, 1, 0}));
}

/// A small cycle that interrupts a large one does not cut it in two. What closes them comes first
/// and last: a way to and fro that is larger than all.
TEST(Rainflow, LargeCyclesAreSeenThroughSmallOnes) {
  Rainflow flow(2);
  const auto add_both = [&](double x) {
    flow.add(0, x);
    flow.add(1, x);
  };
  add_both(-0.2);
  add_both(0.2);
  for (int i = 0; i < 2000; ++i) {
    const double t = 2 * std::numbers::pi * (i + 0.25) / 200;  // ten periods
    flow.add(0, 0.03 * std::sin(t) + 0.003 * std::sin(20 * t));
    flow.add(1, 0.004 * std::sin(t));
  }
  add_both(-0.2);
  add_both(0.2);
  const Counts counts = flow.counts();
  EXPECT_NEAR(counts[2], 10, 1);  // the large ones
  EXPECT_NEAR(counts[1], counts[2], 2);
  EXPECT_NEAR(counts[0], 10 * 20 + 10, 12);  // the small ones between, and those of the second
}

TEST(Rainflow, StandingStillIsNoCycle) {
  Rainflow flow(1);
  for (const double x : {0.0, 0.0, 0.1, 0.1, 0.2, 0.2, 0.2, 0.1, 0.1}) flow.add(0, x);
  EXPECT_EQ(flow.counts(), (Counts{0, 0, 0}));
  flow.add(0, 0.3);
  EXPECT_EQ(flow.counts(), (Counts{1, 1, 1}));  // from 0.2 to 0.1 and back
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
