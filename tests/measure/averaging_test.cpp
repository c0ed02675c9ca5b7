#include "measure/averaging.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace washtub {
namespace {

TEST(Averaging, WholeCyclesWhereThereIsOne) {
  const Averaging a = averaging({1, 9.9}, 5.9, 2);
  EXPECT_EQ(a.cycles, 2U);
  EXPECT_DOUBLE_EQ(a.over.begin, 1);
  EXPECT_DOUBLE_EQ(a.over.end, 5);
  EXPECT_EQ(a.batches.size(), 2U);
}

TEST(Averaging, ElseWhatIsCovered) {
  const Averaging less = averaging({1, 9}, 2.5, 2), none = averaging({1, 9}, 0.5, 2);
  EXPECT_EQ(less.cycles + none.cycles, 0U);
  EXPECT_DOUBLE_EQ(less.over.end, 2.5);
  EXPECT_DOUBLE_EQ(none.over.length(), 0);
  const Averaging parts = averaging({1, 9}, 5, 0);
  EXPECT_EQ(parts.cycles, 0U);
  EXPECT_DOUBLE_EQ(parts.over.end, 5);
  EXPECT_EQ(parts.batches.size(), 8U);
}

TEST(Averaging, SpanAndBatchesRestOnTheSameValues) {
  const std::vector<double> times = {0, 1, 2, 3, 4}, values = {7, 1, 3, 5, 100};
  const Statistic mean = statistic(times, values, averaging({1, 4}, 3.5, 2), Moment::mean);
  EXPECT_DOUBLE_EQ(mean.value, 4);
  EXPECT_EQ(mean.batches, (std::vector<double>{4}));
  EXPECT_DOUBLE_EQ(statistic(times, values, averaging({1, 4}, 3.5, 2), Moment::rms).value,
                   std::sqrt(17));
  EXPECT_TRUE(std::isnan(statistic(times, values, averaging({5, 6}, 4, 1), Moment::mean).value));
}

/// Steps of a drive that goes to and fro, of uneven length but with ends at those of half cycles,
/// and a torque that jumps from step to step.
struct Steps {
  static constexpr double period = std::numbers::pi / 2;
  std::vector<double> ends, torque, swept;

  Steps() {
    std::mt19937 engine(1);
    std::uniform_real_distribution<double> random(0.2, 1);
    std::normal_distribution<double> noise;
    const auto angle = [](double t) { return 1 - std::cos(2 * std::numbers::pi * t / period); };
    for (int half = 0; half < 6; ++half) {
      std::vector<double> shares(400);
      for (double& share : shares) share = random(engine);
      double sum = 0, done = 0;
      for (const double share : shares) sum += share;
      for (const double share : shares) {
        const double from = (half + done / sum) * period / 2;
        done += share;
        ends.push_back((half + done / sum) * period / 2);
        swept.push_back(angle(ends.back()) - angle(from));
        torque.push_back(-5 * swept.back() / (ends.back() - from) + 3 * noise(engine));
      }
    }
  }

  struct Rows {
    std::vector<double> times = {0}, power = {0}, rms = {0};
  };
  /// Rows as the recorder makes them, one for so many steps.
  Rows rows(std::size_t every) const {
    Rows rows;
    double work = 0, squared = 0, before = 0;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      work -= torque[i] * swept[i];
      squared += torque[i] * torque[i] * (ends[i] - (i > 0 ? ends[i - 1] : 0));
      if ((i + 1) % every != 0) continue;
      const double since = ends[i] - before;
      rows.times.push_back(ends[i]);
      rows.power.push_back(work / since);
      rows.rms.push_back(std::sqrt(squared / since));
      before = ends[i], work = squared = 0;
    }
    return rows;
  }
};

/// Energy, power and rms torque are sums over the steps: how many of them make up a row tells
/// nothing, from every step to half a stroke and a whole one.
TEST(Averaging, SumsOverStepsDoNotDependOnTheRows) {
  const Steps steps;
  const Averaging window =
      averaging({Steps::period, 3 * Steps::period}, 3 * Steps::period, Steps::period);
  ASSERT_EQ(window.cycles, 2U);
  const auto of = [&](std::size_t every) {
    const Steps::Rows rows = steps.rows(every);
    const Statistic power = statistic(rows.times, rows.power, window, Moment::mean);
    const Statistic rms = statistic(rows.times, rows.rms, window, Moment::rms);
    return std::array{power.value, power.batches[0], power.batches[1], rms.value, rms.batches[1]};
  };
  const auto finest = of(1);
  EXPECT_GT(finest[0], 1);
  for (const std::size_t every : {2U, 8U, 80U, 400U, 800U})
    for (std::size_t i = 0; i < finest.size(); ++i)
      EXPECT_NEAR(of(every)[i], finest[i], 1e-9 * std::abs(finest[i])) << every << ' ' << i;
}

}  // namespace
}  // namespace washtub
