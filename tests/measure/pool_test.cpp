#include "measure/pool.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace washtub {
namespace {

using Batches = std::vector<std::vector<double>>;

/// Of members whose values are the means of their batches.
Pool pool_of(const Batches& members) {
  std::vector<double> values;
  for (const auto& batches : members)
    values.push_back(std::accumulate(batches.begin(), batches.end(), 0.0) /
                     static_cast<double>(batches.size()));
  return pool(values, members);
}

/// Means 1, 3 and 8: deviation sqrt(13); their own squared errors are 1, 1 and 4 of 2 values each.
TEST(Pool, HandComputed) {
  const Batches members = {{0, 2}, {2, 4}, {6, 10}};
  const Pool p = pool_of(members);
  EXPECT_EQ(p.members, 3U);
  EXPECT_DOUBLE_EQ(p.mean, 4);
  EXPECT_NEAR(p.deviation, std::sqrt(13), 1e-12);
  EXPECT_NEAR(p.half_width, 4.302653 * std::sqrt(13 / 3.0), 1e-5);
  EXPECT_NEAR(p.within, 3.182446 * std::sqrt(2 / 3.0), 1e-5);
  EXPECT_NEAR(p.ratio, 6.5, 1e-12);
  // For 2 and m degrees of freedom the chance is (1 + 2 F/m)^(-m/2).
  EXPECT_NEAR(p.chance, std::pow(1 + 13 / 3.0, -1.5), 1e-12);
  EXPECT_TRUE(p.covered());
  EXPECT_EQ(p.told, 3U);
  EXPECT_EQ(p.hold, 3U);
}

/// As of a root of mean squares, which is no mean of those of the cycles.
TEST(Pool, ValuesAreTheMembersOwn) {
  const std::vector<double> values = {5, 7};
  const Pool p = pool(values, Batches{{0, 2}, {2, 4}});
  EXPECT_DOUBLE_EQ(p.mean, 6);
  EXPECT_NEAR(p.deviation, std::sqrt(2), 1e-12);
  EXPECT_NEAR(p.ratio, 2, 1e-12);
}

TEST(Pool, OneMemberTellsNoSpread) {
  const Batches one = {{1, 2, 3}};
  const Pool p = pool_of(one);
  EXPECT_EQ(p.members, 1U);
  EXPECT_DOUBLE_EQ(p.mean, 2);
  EXPECT_TRUE(std::isnan(p.half_width));
  EXPECT_FALSE(p.covered());
  EXPECT_FALSE(p.not_covered());
}

TEST(Pool, CyclesThatAreAlikeAndMembersThatAreNot) {
  const Batches members = {{1, 1, 1}, {2, 2, 2}};
  EXPECT_TRUE(pool_of(members).not_covered());
  const Batches same = {{1, 1, 1}, {1, 1, 1}};
  EXPECT_FALSE(pool_of(same).not_covered());
}

TEST(Pool, OfSingleValues) {
  const Batches members = {{1}, {2}, {3}};
  const Pool p = pool_of(members);
  EXPECT_NEAR(p.half_width, 4.302653 / std::sqrt(3), 1e-5);
  EXPECT_TRUE(std::isnan(p.within));
  EXPECT_FALSE(p.covered());
}

/// Four members of six cycles, whose starts matter or do not: the pooled interval holds the true
/// mean in 95 % of the ensembles either way, that of the cycles only where they do not, and the
/// test says which is the case.
TEST(Pool, CoversTheTrueMeanAndTellsWhatStartsAdd) {
  std::mt19937 engine(1);
  std::normal_distribution<double> noise;
  constexpr int ensembles = 400;
  for (const double start : {0.0, 1.5}) {
    int pooled = 0, within = 0, covered = 0;
    for (int e = 0; e < ensembles; ++e) {
      Batches members(4);
      for (auto& member : members) {
        const double own = start * noise(engine);
        for (int i = 0; i < 6; ++i) member.push_back(own + noise(engine));
      }
      const Pool p = pool_of(members);
      pooled += std::abs(p.mean) <= p.half_width;
      within += std::abs(p.mean) <= p.within;
      covered += p.covered();
    }
    EXPECT_NEAR(pooled, 0.95 * ensembles, 15);
    if (start == 0) {
      EXPECT_NEAR(within, 0.95 * ensembles, 15);
      EXPECT_NEAR(covered, 0.95 * ensembles, 15);
    } else {
      EXPECT_LT(within, 0.6 * ensembles);
      EXPECT_NEAR(covered, 0.11 * ensembles, 20);  // F(3, 20) < 3.1 / (1 + 6 * 1.5^2)
    }
  }
}

TEST(Drift, OfAStraightLine) {
  const Batches members = {{5, 4, 3, 2}, {11, 10, 9, 8}, {7}};
  const Drift d = drift(members);
  EXPECT_DOUBLE_EQ(d.change, -3);
  EXPECT_NEAR(d.half_width, 0, 1e-9);
  EXPECT_TRUE(d.significant());
}

TEST(Drift, NoiseIsNone) {
  std::mt19937 engine(2);
  std::normal_distribution<double> noise;
  int found = 0;
  for (int e = 0; e < 400; ++e) {
    Batches members(3);
    for (auto& member : members)
      for (int i = 0; i < 5; ++i) member.push_back(100 * e + noise(engine));
    found += drift(members).significant();
  }
  EXPECT_NEAR(found, 20, 13);
}

/// Cycles that remember each other drift for a while without a trend.
TEST(Drift, MemoryIsNone) {
  std::mt19937 engine(4);
  std::normal_distribution<double> noise;
  int found = 0;
  for (int e = 0; e < 400; ++e) {
    Batches members(5);
    for (auto& member : members) {
      double x = 1.67 * noise(engine);
      for (int i = 0; i < 24; ++i) member.push_back(x = 0.8 * x + noise(engine));
    }
    found += drift(members).significant();
  }
  EXPECT_LT(found, 80);  // by cycle it would be 170
}

TEST(Drift, OfSingleCyclesIsUnknown) {
  const Batches members = {{1}, {2}};
  EXPECT_TRUE(std::isnan(drift(members).change));
  EXPECT_FALSE(drift(members).significant());
}

/// t(15) 0.5 / 4 = 0.2664 is the first below 0.2665, t(14) 0.5 / sqrt(15) = 0.2769.
TEST(CountFor, LeastThatIsEnough) {
  EXPECT_EQ(count_for(0.5, 0.2665), 16);
  EXPECT_EQ(count_for(0.5, 0.2769), 15);
  EXPECT_EQ(count_for(0, 1), 2);
  EXPECT_TRUE(std::isnan(count_for(1, 0)));
}

TEST(Paired, DifferencesOfWhatStartsAlike) {
  const std::vector<double> a = {1, 5, 9}, b = {2, 6.5, 9.5};
  const DifferenceEstimate d = paired(a, b);
  EXPECT_DOUBLE_EQ(d.difference, 1);
  EXPECT_NEAR(d.half_width, 4.302653 * 0.5 / std::sqrt(3), 1e-5);
  EXPECT_THROW(paired(a, {b.data(), 2}), std::logic_error);
}

}  // namespace
}  // namespace washtub
