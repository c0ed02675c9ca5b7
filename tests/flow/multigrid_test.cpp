#include "flow/pressure/multigrid.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/wash_tub.hpp"

namespace washtub {
namespace {

/// A smooth source with some noise.
void fill_source(const Grid<3>& grid, Multigrid<3>& mg) {
  const auto& block = grid.block();
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j)
      for (int i = 0; i < block.width(); ++i) {
        const long q = block.at({i, j, k});
        const auto x = grid.position({i, j, k});
        const auto c = block.row_cell(j, k);
        const double noise = std::sin(12.9898 * i + 78.233 * c[1] + 37.719 * c[2]) * 43758.5453;
        const double value = std::sin(7 * x[0] + 4 * x[1]) * std::cos(17 * x[2] - 3 * x[0]);
        mg.source()[q] =
            mg.inverse_diagonal()[q] > 0 ? value + 0.3 * (noise - std::floor(noise) - 0.5) : 0.0;
      }
}

/// Takes the mean over the live cells of all ranks out of the source.
void make_compatible(const Grid<3>& grid, Multigrid<3>& mg) {
  const auto& block = grid.block();
  std::array<double, 2> sums{};
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j)
      for (int i = 0; i < block.width(); ++i) {
        const long q = block.at({i, j, k});
        if (mg.inverse_diagonal()[q] > 0) sums[0] += mg.source()[q], sums[1] += 1;
      }
  grid.parallel().sum(std::span<double>(sums));
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j)
      for (int i = 0; i < block.width(); ++i) {
        const long q = block.at({i, j, k});
        if (mg.inverse_diagonal()[q] > 0) mg.source()[q] -= sums[0] / sums[1];
      }
}

struct Cycles {
  int coarse, fine;
};

/// Cycles for a residual smaller by 1e4 and by 1e8.
Cycles count_cycles(int n, bool agitator) {
  const Grid<3> grid(testing::wash_mesh(n), Parallel(), granularity(testing::wash_mesh(n)));
  DomainMapping<3> mapping(grid, testing::wash_solids(agitator), 0);
  mapping.update(0.2);
  Multigrid<3> mg(grid, 1000, mapping.open());
  fill_source(grid, mg);
  make_compatible(grid, mg);
  const double start = mg.solve(1e30, 0).residual;
  const auto coarse = mg.solve(1e-4 * start, 40);
  const auto fine = mg.solve(1e-8 * start, 40);
  EXPECT_TRUE(coarse.converged && fine.converged);
  return {coarse.cycles, coarse.cycles + fine.cycles};
}

TEST(Multigrid, ConvergesInFewCyclesOnEveryGrid) {
  for (const bool agitator : {false, true})
    for (const int n : {32, 64, 128}) {
      const auto [coarse, fine] = count_cycles(n, agitator);
      EXPECT_LE(coarse, 7) << n << " cells, agitator " << agitator;
      EXPECT_LE(fine, 12) << n << " cells, agitator " << agitator;
    }
}

}  // namespace
}  // namespace washtub
