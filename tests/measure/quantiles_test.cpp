#include "measure/quantiles.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace washtub {
namespace {

TEST(Quantiles, OfEqualWeights) {
  std::vector<Weighted> values;
  for (int i = 100; i > 0; --i) values.push_back({static_cast<double>(i), 0.3});
  const auto found = quantiles<3>(values, {0.5, 0.9, 0.99});
  EXPECT_EQ(found, (std::array{50.0, 90.0, 99.0}));
}

TEST(Quantiles, WeightsCount) {
  std::vector<Weighted> values = {{5, 1}, {1, 8}, {9, 1}};
  EXPECT_EQ(quantiles<3>(values, {0.5, 0.85, 1}), (std::array{1.0, 5.0, 9.0}));
}

TEST(Quantiles, OfNothing) {
  std::vector<Weighted> none;
  EXPECT_TRUE(std::isnan(quantiles<1>(none, {0.5})[0]));
}

}  // namespace
}  // namespace washtub
