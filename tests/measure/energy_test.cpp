#include "measure/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace washtub {
namespace {

using std::numbers::pi;

/// Torque c omega against a drive omega = w sin(2 pi t / T), sampled `per_cycle` times.
std::vector<TorqueSample> damped_stroke(double c, double w, double T, int per_cycle, int cycles) {
  std::vector<TorqueSample> samples;
  const auto angle = [&](double t) { return w * T / (2 * pi) * (1 - std::cos(2 * pi * t / T)); };
  for (int i = 0; i < per_cycle * cycles; ++i) {
    const Interval over{i * T / per_cycle, (i + 1) * T / per_cycle};
    const double swept = angle(over.end) - angle(over.begin);
    samples.push_back({over, c * swept, swept / over.length()});
  }
  return samples;
}

TEST(Energy, ViscousStrokeDoesTheWorkOfItsMeanSquareSpeed) {
  const auto samples = damped_stroke(0.5, 12, 1.6, 200, 3);
  const double per_cycle = 0.5 * 144 / 2 * 1.6;
  EXPECT_NEAR(work(samples, {0, 4.8}), 3 * per_cycle, 1e-3 * per_cycle);
  EXPECT_NEAR(mean_power(samples, {1.6, 3.2}), per_cycle / 1.6, 1e-3 * per_cycle);
  const auto cycles = energy_per_cycle(samples, {1.6, 4.8}, 1.6);
  ASSERT_EQ(cycles.size(), 2);
  for (const double e : cycles) EXPECT_NEAR(e, per_cycle, 1e-3 * per_cycle);
}

TEST(Energy, SamplesAcrossTheWindowsEdgeCountInPart) {
  const std::vector<TorqueSample> samples = {{{0, 2}, 3, 4}, {{2, 3}, 1, -5}};
  EXPECT_DOUBLE_EQ(work(samples, {1, 2.5}), 6 - 2.5);
  EXPECT_DOUBLE_EQ(mean_power(samples, {1, 9}), (6 - 5) / 2.0);
  EXPECT_TRUE(std::isnan(mean_power(samples, {5, 9})));
}

TEST(Energy, SamplesWithoutLengthDoNotCount) {
  const std::vector<TorqueSample> samples = {{{0, 1}, 3, 2}, {{1, 1}, 0, 0}, {{1, 2}, 1, 4}};
  EXPECT_DOUBLE_EQ(work(samples, {0, 2}), 10);
}

TEST(Energy, UnfinishedCyclesAreLeftOut) {
  const std::vector<TorqueSample> samples = {{{0, 1}, 1, 1}, {{1, 2.5}, 3, 1}};
  EXPECT_EQ(energy_per_cycle(samples, {0, 9}, 1).size(), 2);
  EXPECT_DOUBLE_EQ(energy_per_cycle(samples, {0, 9}, 1)[1], 2);
  EXPECT_EQ(energy_per_cycle(samples, {0, 1.5}, 1).size(), 1);  // the window ends
  EXPECT_TRUE(energy_per_cycle({}, {0, 9}, 1).empty());
  EXPECT_TRUE(energy_per_cycle(samples, {-1, 9}, 1).empty());
}

}  // namespace
}  // namespace washtub
