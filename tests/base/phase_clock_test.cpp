#include "base/phase_clock.hpp"

#include <gtest/gtest.h>

#include <numeric>

using namespace washtub;

namespace {

double spent(const PhaseClock& clock, Phase phase) {
  return clock.spent()[static_cast<std::size_t>(phase)];
}

void pass_time() {
  const auto start = std::chrono::steady_clock::now();
  while (std::chrono::steady_clock::now() - start < std::chrono::milliseconds(2)) {
  }
}

}  // namespace

TEST(PhaseClock, GivesEveryMomentToOnePhase) {
  const auto start = std::chrono::steady_clock::now();
  PhaseClock clock;
  clock.enter(Phase::projection);
  pass_time();
  clock.enter(Phase::output);
  pass_time();
  EXPECT_EQ(clock.enter(Phase::rest), Phase::output);
  const double all =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  EXPECT_GE(spent(clock, Phase::projection), 2e-3);
  EXPECT_GE(spent(clock, Phase::output), 2e-3);
  EXPECT_EQ(spent(clock, Phase::loads), 0);
  EXPECT_LE(std::accumulate(clock.spent().begin(), clock.spent().end(), 0.0), all);
}

TEST(PhaseClock, GoesOnWithThePhaseAroundAnother) {
  PhaseClock clock;
  clock.enter(Phase::exchange);
  {
    const InPhase within(&clock, Phase::cloth);
    pass_time();
  }
  EXPECT_EQ(clock.enter(Phase::rest), Phase::exchange);
  EXPECT_GE(spent(clock, Phase::cloth), 2e-3);
}
