#include "flow/warm_start.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace washtub {
namespace {

struct Seen {
  bool held;  ///< the viscous solve holds the last pressure gradient
  double last, before;
  bool operator==(const Seen&) const = default;
};

/// What each of a number of steps without a flip is given.
std::vector<Seen> calm_steps(WarmStart& start, int steps) {
  std::vector<Seen> seen;
  for (int s = 0; s < steps; ++s) {
    const bool held = start.gradient_holds();
    start.next_step();
    seen.push_back({held, start.guess().last, start.guess().before});
  }
  return seen;
}

const std::vector<Seen> after_a_flip{
    {false, 0, 0}, {false, 0, 0}, {true, 1, 0}, {true, 2, -1}, {true, 2, -1}};

TEST(WarmStart, TheStartCountsAsAFlip) {
  WarmStart start;
  EXPECT_EQ(calm_steps(start, 5), after_a_flip);
}

TEST(WarmStart, AFlipMakesTheLastPressuresWorthless) {
  WarmStart start;
  calm_steps(start, 5);
  start.flip();
  EXPECT_EQ(calm_steps(start, 5), after_a_flip);
}

TEST(WarmStart, AForceReleasesTheGradientOnly) {
  WarmStart start;
  calm_steps(start, 5);
  start.set_forced(true);
  EXPECT_EQ(calm_steps(start, 1), (std::vector<Seen>{{false, 2, -1}}));
  start.set_forced(false);
  EXPECT_TRUE(start.gradient_holds());
}

}  // namespace
}  // namespace washtub
