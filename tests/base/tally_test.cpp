#include "base/tally.hpp"

#include <gtest/gtest.h>

namespace washtub {
namespace {

/// Alone, a tally is what it was; the tests of flow hold it on several ranks.
TEST(Tally, OfOneRankStaysAsItIs) {
  Tally tally{{1.5, -2}, {3, 0.25}};
  combine(Parallel(MPI_COMM_SELF), tally);
  EXPECT_EQ(tally.sum, (std::array<double, 4>{1.5, -2, 0, 0}));
  EXPECT_EQ(tally.max, (std::array<double, 4>{3, 0.25, 0, 0}));
}

}  // namespace
}  // namespace washtub
