#include "washer/slip_cut.hpp"

#include <gtest/gtest.h>

using namespace washtub;

TEST(SlipCut, CutsWhereThatHelps) {
  SlipCut cut;
  for (int i = 0; i < 20; ++i) cut.look(0.2 * cut.factor());
  EXPECT_LT(cut.factor(), 0.3);
  for (int i = 0; i < 20; ++i) cut.look(0.01);
  EXPECT_EQ(cut.factor(), 1);
}

/// Nor where it helped first and slip stays above the limit at the shortest step.
TEST(SlipCut, LetsGoWhereItDoesNotHelpAnyMore) {
  SlipCut cut;
  cut.look(0.5);
  double sum = 0;
  for (int i = 0; i < 1000; ++i) {
    cut.look(0.06);
    sum += cut.factor() / 1000;
  }
  EXPECT_GT(sum, 0.8);
}

TEST(SlipCut, LetsGoWhereItDoesNot) {
  SlipCut cut;
  double least = 1, sum = 0;
  for (int i = 0; i < 1000; ++i) {
    cut.look(0.1);
    least = std::min(least, cut.factor());
    sum += cut.factor() / 1000;
  }
  EXPECT_GT(least, 0.3);
  EXPECT_GT(sum, 0.9);
}
