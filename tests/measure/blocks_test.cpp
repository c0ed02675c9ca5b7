#include "measure/blocks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "measure/cycles.hpp"

namespace washtub {
namespace {

using ::testing::ElementsAre;

/// n values of a process whose neighbours have the correlation `memory`, with mean 0.
std::vector<double> correlated(std::size_t n, double memory, std::mt19937& engine) {
  std::normal_distribution<double> noise;
  std::vector<double> values;
  double x = noise(engine) / std::sqrt(1 - memory * memory);
  for (std::size_t i = 0; i < n; ++i) values.push_back(x = memory * x + noise(engine));
  return values;
}

TEST(Blocks, EndWithTheLastBatch) {
  const std::vector<double> batches = {9, 1, 3, 5, 7};
  EXPECT_THAT(blocks(batches, 1), ElementsAre(9, 1, 3, 5, 7));
  EXPECT_THAT(blocks(batches, 2), ElementsAre(2, 6));
  EXPECT_THAT(blocks(batches, 6), ElementsAre());
}

TEST(BlockLength, AFewBatchesTellNoCorrelation) {
  const std::vector<std::vector<double>> few = {{1, 2, 3}};
  EXPECT_EQ(block_length(few), 1U);
  EXPECT_EQ(block_length({}), 1U);
  const std::vector<std::vector<double>> same = {{4, 4, 4, 4, 4, 4, 4, 4, 4, 4}};
  EXPECT_EQ(block_length(same), 1U);
}

/// What eight cycles of one member leave open thirty members show together.
TEST(BlockLength, MembersTellItTogether) {
  std::mt19937 engine(3);
  std::vector<std::vector<double>> members;
  for (int i = 0; i < 30; ++i) members.push_back(correlated(8, 0.9, engine));
  EXPECT_GT(block_length(members), 1U);
  for (auto& member : members) member = correlated(8, 0, engine);
  EXPECT_EQ(block_length(members), 1U);
}

/// Five members of eight independent cycles seem correlated in one case of twenty.
TEST(BlockLength, HasTheLevelThatItSays) {
  std::mt19937 engine(5);
  int found = 0;
  for (int e = 0; e < 1000; ++e) {
    std::vector<std::vector<double>> members;
    for (int i = 0; i < 5; ++i) members.push_back(correlated(8, 0, engine));
    found += block_length(members) > 1;
  }
  EXPECT_GT(found, 20);
  EXPECT_LT(found, 90);
}

/// 64 batches whose neighbours have the correlation 0.8: an interval from each of them holds the
/// true mean in half of the runs, one from blocks nearly as often as it says. Independent ones are
/// hardly widened.
TEST(IndependentBlocks, MakeIntervalsHonest) {
  std::mt19937 engine(1);
  constexpr int runs = 400;
  int plain = 0, blocked = 0, wide = 0;
  for (int run = 0; run < runs; ++run) {
    const auto values = correlated(64, 0.8, engine);
    const auto holds = [](const MeanEstimate& e) { return std::abs(e.mean) <= e.half_width; };
    plain += holds(mean_of_batches(values));
    blocked += holds(mean_of_batches(independent_blocks(values)));
    wide += independent_blocks(correlated(64, 0, engine)).size() < 64;
  }
  EXPECT_LT(plain, 0.6 * runs);
  EXPECT_GT(blocked, 0.85 * runs);
  EXPECT_NEAR(wide, 0.05 * runs, 15);
}

}  // namespace
}  // namespace washtub
