#include "record/schedule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/snapshot.hpp"

namespace washtub {
namespace {

using ::testing::ElementsAre;

Case run(double end, double every, double frames, std::array<double, 2> window, double period) {
  Case whole;
  whole.time.end = end;
  whole.output = {every, frames, window[0], window[1]};
  whole.scale.period = period;
  return whole;
}

std::vector<double> rows(const Case& whole) {
  const Schedule schedule(whole);
  std::vector<double> times;
  for (double t = 0; !schedule.reached(t, whole.time.end);) times.push_back(t = schedule.next(t));
  return times;
}

TEST(Schedule, RowsStandAtMultiplesAndTheEnd) {
  EXPECT_THAT(rows(run(1, 0.3, 0, {0, 1}, 0)), ElementsAre(0.3, 0.6, 3 * 0.3, 1));
}

/// The last multiple is 1e-7 s before the end.
TEST(Schedule, NearlyEqualTimesAreOne) {
  EXPECT_THAT(rows(run(0.1, 0.0333333, 0, {0, 0.1}, 0)),
              ElementsAre(0.0333333, 2 * 0.0333333, 0.1));
}

TEST(Schedule, RowsStandAtTheEndsOfWindowAndCycles) {
  EXPECT_THAT(rows(run(1, 0.4, 0, {0.1, 0.95}, 0.25)),
              ElementsAre(0.1, 0.35, 0.4, 0.6, 0.8, 0.85, 0.95, 1));
}

TEST(Schedule, CyclesThatMeetMultiplesAddNoRows) {
  EXPECT_EQ(rows(run(1, 0.1, 0, {0.2, 1}, 0.2 * (1 + 1e-15))).size(), 10U);
}

/// Fixed steps do not meet the times; the step nearest to one stands for it.
TEST(Schedule, AFixedStepNearATimeStandsForIt) {
  Case whole = run(1, 0.25, 0, {0, 1}, 0);
  whole.time.fixed = true;
  whole.time.step = 0.1;
  const Schedule schedule(whole);
  EXPECT_TRUE(schedule.reached(0.21, 0.25));
  EXPECT_FALSE(schedule.reached(0.19, 0.25));
  EXPECT_EQ(schedule.next(0.21), 0.5);
}

TEST(Schedule, FramesComeAtTheFirstRowFromTheirTimeOn) {
  const Case whole = run(1, 0.1, 0.25, {0, 1}, 0);
  Schedule schedule(whole);
  std::vector<double> frames;
  for (double t = 0; !schedule.reached(t, 1);)
    if (schedule.take_frame(t = schedule.next(t))) frames.push_back(std::round(10 * t));
  EXPECT_THAT(frames, ElementsAre(3, 5, 8, 10));
}

/// A run that goes on with frames further apart, or nearer, has them from then on.
TEST(Schedule, FramesGoOnAtAnotherInterval) {
  for (const double interval : {0.4, 0.1}) {
    Schedule before(run(1, 0.05, 0.25, {0, 1}, 0)), after(run(1, 0.05, interval, {0, 1}, 0));
    for (double t = 0; !before.reached(t, 0.5);) before.take_frame(t = before.next(t));
    Snapshot saved;
    saved.take(before);
    saved.put_back(after);
    std::vector<double> frames;
    for (double t = 0.5; !after.reached(t, 1);)
      if (after.take_frame(t = after.next(t))) frames.push_back(std::round(20 * t));
    if (interval > 0.25)
      EXPECT_THAT(frames, ElementsAre(16));
    else
      EXPECT_THAT(frames, ElementsAre(12, 14, 16, 18, 20));
  }
}

}  // namespace
}  // namespace washtub
