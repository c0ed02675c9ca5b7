#include "measure/cycles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace washtub {
namespace {

TEST(StudentT, PrintedTable) {
  EXPECT_NEAR(student_95(1), 12.706, 5e-4);
  EXPECT_NEAR(student_95(2), 4.303, 5e-4);
  EXPECT_NEAR(student_95(3), 3.182, 5e-4);
  EXPECT_NEAR(student_95(10), 2.228, 5e-4);
  EXPECT_NEAR(student_95(30), 2.042, 5e-4);
  EXPECT_NEAR(student_95(1000), 1.962, 5e-4);
}

TEST(WholeCycles, FillTheCoveredWindowFromItsBegin) {
  const auto cycles = whole_cycles({1, 6}, 5.4, 2);
  ASSERT_EQ(cycles.size(), 2U);
  EXPECT_DOUBLE_EQ(cycles[1].begin, 3);
  EXPECT_DOUBLE_EQ(cycles[1].end, 5);
  EXPECT_EQ(whole_cycles({0, 3 * 0.1}, 1, 0.1).size(), 3U);  // 0.3 / 0.1 < 3 in doubles
  EXPECT_EQ(whole_cycles({1, 6}, 1, 2).size(), 0U);
}

TEST(WholeCycles, EightPartsWithoutAPeriod) {
  const auto parts = whole_cycles({1, 6}, 5, 0);
  ASSERT_EQ(parts.size(), 8U);
  EXPECT_DOUBLE_EQ(parts[7].end, 5);
}

TEST(OverSpan, ValuesStandForTheTimeBeforeThem) {
  const std::vector<double> times = {0, 1, 3, 4}, values = {100, 6, 2, std::nan("")};
  EXPECT_DOUBLE_EQ(over_span(times, values, {0, 3}).mean(), (6 + 2 * 2) / 3.0);
  EXPECT_DOUBLE_EQ(over_span(times, values, {0.5, 2}).mean(), (0.5 * 6 + 2) / 1.5);
  EXPECT_DOUBLE_EQ(over_span(times, values, {0, 4}).weight(), 3);
  EXPECT_TRUE(std::isnan(over_span(times, values, {5, 6}).mean()));
}

TEST(MeanOfBatches, KnownSmallSample) {
  const std::vector<double> batches = {1, 5};
  EXPECT_DOUBLE_EQ(mean_of_batches(batches).mean, 3);
  EXPECT_NEAR(mean_of_batches(batches).half_width, 12.7062 * std::sqrt(8.0) / std::sqrt(2.0), 1e-3);
  EXPECT_TRUE(std::isnan(mean_of_batches({batches.data(), 1}).half_width));
  EXPECT_TRUE(std::isnan(mean_of_batches({}).mean));
}

TEST(MeanOfBatches, CoversTheTrueMeanOfACorrelatedSignal) {
  std::mt19937 engine(1);
  std::normal_distribution<double> noise;
  std::vector<double> times(2001);
  for (std::size_t i = 0; i < times.size(); ++i) times[i] = static_cast<double>(i);
  int covered = 0;
  for (int run = 0; run < 200; ++run) {
    std::vector<double> values, batches;
    for (double x = 0; values.size() < times.size(); values.push_back(x))
      x = 0.9 * x + noise(engine);
    for (const Interval& part : whole_cycles({0, 2000}, 2000, 250))
      batches.push_back(over_span(times, values, part).mean());
    const MeanEstimate e = mean_of_batches(batches);
    covered += std::abs(e.mean) < e.half_width;
  }
  EXPECT_NEAR(covered, 190, 12);  // 95 % of 200
}

/// Student's sleep data (Biometrika 6, 1908) with the interval and degrees of freedom that R prints
/// for it, t.test(extra ~ group, sleep).
TEST(Welch, SleepData) {
  const std::vector<double> a = {0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0};
  const std::vector<double> b = {1.9, 0.8, 1.1, 0.1, -0.1, 4.4, 5.5, 1.6, 4.6, 3.4};
  const DifferenceEstimate d = welch(a, b);
  EXPECT_NEAR(d.freedom, 17.776, 5e-4);
  EXPECT_NEAR(d.difference - d.half_width, -0.2054832, 1e-6);
  EXPECT_NEAR(d.difference + d.half_width, 3.3654832, 1e-6);
}

TEST(Welch, HandComputed) {
  const std::vector<double> a = {1, 3}, b = {4, 6, 8};  // variances of means 1 and 4/3
  const DifferenceEstimate d = welch(a, b);
  EXPECT_DOUBLE_EQ(d.difference, 4);
  EXPECT_NEAR(d.freedom, (7.0 / 3) * (7.0 / 3) / (1.0 + (16.0 / 9) / 2), 1e-12);
  EXPECT_NEAR(d.half_width, student_95(d.freedom) * std::sqrt(7.0 / 3), 1e-12);
  EXPECT_TRUE(std::isnan(welch({a.data(), 1}, b).half_width));
}

/// Two means of the same thing seem different about once in twenty times.
TEST(Welch, EqualSourcesDifferSignificantlyInFivePercent) {
  std::mt19937 engine(2);
  std::normal_distribution<double> noise;
  int significant = 0;
  for (int run = 0; run < 400; ++run) {
    std::vector<double> a(5), b(8);
    for (double& x : a) x = noise(engine);
    for (double& x : b) x = 3 * noise(engine);
    const DifferenceEstimate d = welch(a, b);
    significant += std::abs(d.difference) > d.half_width;
  }
  EXPECT_NEAR(significant, 20, 12);
}

}  // namespace
}  // namespace washtub
