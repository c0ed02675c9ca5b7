#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "grid/grid.hpp"

namespace washtub {
namespace {

TEST(CutAxis, PartsCoverTheAxisWithoutGapsOnMultiplesOfTheUnit) {
  for (const auto [n, unit] : {std::array{64, 1},
                               {64, 8},
                               {48, 16},
                               {7, 1},
                               {20, 4},
                               {33, 8},
                               {65, 16},
                               {50, 8},
                               {97, 32},
                               {9, 8}})
    for (int parts = 1; parts <= std::min(7, (n + unit - 1) / unit); ++parts) {
      int next = 0;
      for (int part = 0; part < parts; ++part) {
        const auto [first, count] = cut_axis(n, unit, parts, part);
        EXPECT_EQ(first, next) << n << " cells, part " << part << " of " << parts;
        EXPECT_EQ(first % unit, 0);
        EXPECT_GT(count, 0);
        next = first + count;
      }
      EXPECT_EQ(next, n) << parts << " parts";
    }
}

TEST(CutAxis, LargestAndSmallestPartDifferByOneUnitAtMost) {
  for (int parts = 1; parts <= 7; ++parts) {
    int least = 96, most = 0;
    for (int part = 0; part < parts; ++part) {
      const int count = cut_axis(96, 8, parts, part)[1];
      least = std::min(least, count);
      most = std::max(most, count);
    }
    EXPECT_LE(most - least, 8) << parts << " parts";
  }
}

TEST(CutAxis, EdgesAreTheNearestToAnEvenCut) {
  EXPECT_EQ(cut_axis(33, 8, 2, 0)[1], 16);
  EXPECT_EQ(cut_axis(65, 16, 2, 0)[1], 32);
  EXPECT_EQ(cut_axis(50, 8, 2, 0)[1], 24);
}

TEST(ChooseRanks, TheLargestPartCountsWhereverItLies) {
  EXPECT_EQ((choose_ranks<3>({40, 39, 39}, {1, 13, 8}, 3)), (Index<3>{1, 3, 1}));
}

/// About the axis of a tub cloth lies more evenly than along its height.
TEST(ChooseRanks, CutsAlongYWhereBothAreEqual) {
  EXPECT_EQ((choose_ranks<3>({64, 64, 64}, {8, 8, 8}, 2)), (Index<3>{1, 2, 1}));
}

TEST(ChooseRanks, UsesEveryRankAndLeavesRowsWhole) {
  for (int size = 1; size <= 7; ++size) {
    const auto ranks = choose_ranks<3>({64, 64, 64}, {8, 8, 8}, size);
    EXPECT_EQ(ranks[0], 1);
    EXPECT_EQ(ranks[1] * ranks[2], size);
    EXPECT_EQ((choose_ranks<2>({64, 64}, {8, 8}, size)), (Index<2>{1, size}));
  }
}

TEST(ChooseRanks, RespectsTheUnitOfEachAxis) {
  EXPECT_EQ((choose_ranks<3>({32, 32, 32}, {8, 8, 32}, 4)), (Index<3>{1, 4, 1}));
  EXPECT_EQ((choose_ranks<3>({32, 32, 32}, {8, 32, 8}, 4)), (Index<3>{1, 1, 4}));
}

TEST(ChooseRanks, TooManyRanksIsTheUsersError) {
  const auto ask = [](int size) { return choose_ranks<3>({16, 16, 16}, {8, 8, 8}, size); };
  EXPECT_NO_THROW(ask(4));
  try {
    ask(5);
    FAIL() << "5 ranks cannot share 2 x 2 units";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("5 ranks are too many"));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("try fewer"));
  }
  EXPECT_THROW((choose_ranks<2>({64, 16}, {8, 8}, 3)), InputError);
}

TEST(Grid, BlocksOfAllRanksTileTheMesh) {
  Mesh<3> mesh{Vec<3>::Zero(), Vec<3>::Ones(), {16, 24, 16}, {}};
  const Grid<3> grid(mesh, Parallel(), {1, 8, 4});
  const auto& block = grid.block();
  const double cells = static_cast<double>(block.width()) * block.rows() * block.planes();
  EXPECT_EQ(grid.parallel().sum(cells), 16 * 24 * 16);
  for (int axis = 1; axis < 3; ++axis) {
    const int first = block.offset[axis], end = first + block.count[axis];
    EXPECT_EQ(grid.at_side(axis, 0), first == 0);
    EXPECT_EQ(grid.at_side(axis, 1), end == mesh.cells[axis]);
  }
}

/// Sum over the cells of a number unique to each: only an exact tiling reproduces it.
TEST(Grid, PositionsAreThoseOfTheWholeMesh) {
  Mesh<2> mesh{Vec<2>(-1, 2), Vec<2>(0.5, 0.25), {8, 12}, {}};
  const Grid<2> grid(mesh, Parallel(), {1, 4});
  double sum = 0;
  for (int k = 0; k < grid.block().planes(); ++k)
    sum += std::exp(grid.position({3, k})[1]) + grid.position({3, k}, 0)[0];
  double expected = 0;
  for (int k = 0; k < 12; ++k) expected += std::exp(2 + 0.25 * (k + 0.5)) + (-1 + 0.5 * 3);
  EXPECT_NEAR(grid.parallel().sum(sum), expected, 1e-12 * expected);
}

}  // namespace
}  // namespace washtub
