#include "measure/energy_balance.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace washtub {
namespace {

/// A spring-mounted mass with friction that is driven at power 3 t, loses heat at rate 2 t and a
/// tenth of the work to something else: E = 0.9 * 1.5 t^2 - t^2.
EnergyState driven(double t) {
  const double work = 1.5 * t * t;
  return {.time = t, .stored = 0.9 * work - t * t, .work = work, .dissipation = 2 * t};
}

TEST(EnergyBalance, FindsWhatIsLostElsewhere) {
  EnergyBalance balance;
  for (int i = 0; i < 10; ++i) balance.add(driven(0.1 * i), driven(0.1 * (i + 1)));
  EXPECT_NEAR(balance.time, 1, 1e-12);
  EXPECT_NEAR(balance.work, 1.5, 1e-12);
  EXPECT_NEAR(balance.heat, 1, 1e-12);
  EXPECT_NEAR(balance.rest(), 0.15, 1e-12);
  EXPECT_NEAR(balance.share(), 0.1, 1e-12);
}

/// Where nothing is put in, what is lost counts against the heat.
TEST(EnergyBalance, OfADecay) {
  const auto decaying = [](double t) {
    return EnergyState{.time = t, .stored = 2 * std::exp(-t), .dissipation = 1.5 * std::exp(-t)};
  };
  EnergyBalance balance;
  for (int i = 0; i < 100; ++i) balance.add(decaying(0.01 * i), decaying(0.01 * (i + 1)));
  EXPECT_NEAR(balance.share(), 0.5 / 1.5, 1e-4);
}

TEST(EnergyBalance, OfNothingIsZero) { EXPECT_EQ(EnergyBalance().share(), 0); }

}  // namespace
}  // namespace washtub
