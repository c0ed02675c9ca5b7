#include "measure/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace washtub {
namespace {

TEST(Interval, OverlapIsTheSharedTime) {
  const Interval window{1, 3};
  EXPECT_DOUBLE_EQ(window.overlap({0, 1.5}), 0.5);
  EXPECT_DOUBLE_EQ(window.overlap({1.5, 2}), 0.5);
  EXPECT_DOUBLE_EQ(window.overlap({0, 9}), 2);
  EXPECT_DOUBLE_EQ(window.overlap({3, 4}), 0);
}

TEST(Statistics, WeightsCountAsRepetitions) {
  Statistics weighted, repeated;
  weighted.add(2, 3);
  weighted.add(-1, 1);
  weighted.add(100, 0);
  for (const double v : {2.0, 2.0, 2.0, -1.0}) repeated.add(v);
  EXPECT_DOUBLE_EQ(weighted.mean(), 1.25);
  EXPECT_DOUBLE_EQ(weighted.rms(), std::sqrt(13.0 / 4));
  EXPECT_DOUBLE_EQ(weighted.deviation(), std::sqrt(13.0 / 4 - 1.25 * 1.25));
  EXPECT_DOUBLE_EQ(repeated.deviation(), weighted.deviation());
}

TEST(Statistics, SmallSpreadAboutALargeMeanIsNotLost) {
  Statistics s;
  for (const double v : {1e9 + 1, 1e9 - 1}) s.add(v);
  EXPECT_DOUBLE_EQ(s.deviation(), 1);
}

TEST(Statistics, NothingKnownBeforeTheFirstSample) {
  EXPECT_TRUE(std::isnan(Statistics().mean()) && std::isnan(Statistics().deviation()));
}

TEST(BatchMeans, KnownSmallSeries) {
  const std::vector<double> series = {9, 0, 2, 4, 6};  // batches (0, 2), (4, 6): means 1 and 5
  const MeanEstimate e = batch_means(series, 2);
  EXPECT_DOUBLE_EQ(e.mean, 4.2);
  EXPECT_NEAR(e.half_width, 12.706 * std::sqrt(8.0) / std::sqrt(2.0), 1e-12);
}

TEST(BatchMeans, PeriodicSeriesInWholePeriodsIsCertain) {
  std::vector<double> series;
  for (int i = 0; i < 160; ++i) series.push_back(3 + std::sin(2 * M_PI * i / 20));
  const MeanEstimate e = batch_means(series, 8);
  EXPECT_NEAR(e.mean, 3, 1e-12);
  EXPECT_NEAR(e.half_width, 0, 1e-12);
}

TEST(BatchMeans, CoversTheTrueMeanOfACorrelatedSeries) {
  std::mt19937 engine(1);
  std::normal_distribution<double> noise;
  int covered = 0;
  for (int run = 0; run < 200; ++run) {
    std::vector<double> series;
    for (double x = 0; series.size() < 2000; series.push_back(x)) x = 0.9 * x + noise(engine);
    const MeanEstimate e = batch_means(series);
    covered += std::abs(e.mean) < e.half_width;
  }
  EXPECT_NEAR(covered, 190, 12);  // 95 % of 200
}

TEST(BatchMeans, TooFewSamplesLeaveItUnknown) {
  EXPECT_TRUE(std::isnan(batch_means(std::vector<double>{1, 2, 3}, 8).half_width));
  EXPECT_TRUE(std::isnan(batch_means({}, 8).mean));
}

}  // namespace
}  // namespace washtub
