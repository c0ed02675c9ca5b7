#include "grid/wavefront.hpp"

#include <gtest/gtest.h>

#include "grid/meshes.hpp"

namespace washtub {
namespace {

using testing::any_cut;
using testing::for_cells;
using testing::unit_mesh;

/// A red-black stencil that works in place, as the solvers' sweeps do.
template <int D>
struct Stencil {
  const Grid<D>& grid;
  Field x;

  explicit Stencil(const Grid<D>& grid_) : grid(grid_), x(grid_.make_field()) {
    for_cells(grid.block(), 0, [&](const Index<D>& c) {
      double seed = 0;
      for (int d = 0; d < D; ++d) seed = 7.3 * seed + c[d] + grid.block().offset[d];
      x[grid.block().at(c)] = std::sin(seed);
    });
    grid.halo().exchange(x.data());
  }
  void rows(int s, int k, int j0, int j1) {
    const auto& block = grid.block();
    for (int j = j0; j < j1; ++j) {
      double* row = x.data() + block.row(j, k);
      for (int i = (block.parity(j, k) + s) & 1; i < block.width(); i += 2) {
        double sum = row[i - 1] + 2 * row[i + 1];
        for (int d = 1; d < D; ++d) sum += d * row[i - block.stride[d]] - row[i + block.stride[d]];
        row[i] = 0.4 * row[i] + 0.1 * (s + 1) * sum;
      }
      grid.halo().wrap_row(row);
    }
  }
};

/// Stage after stage over the whole block.
template <int D>
Field unfused(const Grid<D>& grid, int stages) {
  Stencil<D> stencil(grid);
  for (int s = 0; s < stages; ++s) {
    for (int k = 0; k < grid.block().planes(); ++k) stencil.rows(s, k, 0, grid.block().rows());
    grid.halo().exchange(stencil.x.data());
  }
  return std::move(stencil.x);
}

/// Largest difference within a plane and the planes next to it, ghosts included.
template <int D>
double difference(const Block<D>& block, const Field& a, const Field& b, int plane) {
  double largest = 0;
  for_cells(block, 0, [&](Index<D> c) {
    if (std::abs(c[D - 1] - plane) > 1) return;
    largest = std::max(largest, std::abs(a[block.at(c)] - b[block.at(c)]));
  });
  return largest;
}

template <int D>
void compare(const Mesh<D>& mesh, int stages) {
  const Grid<D> grid(mesh, Parallel(), any_cut<D>());
  const Field expected = unfused(grid, stages);
  Stencil<D> fused(grid);
  int finished = 0, planes = grid.block().planes();
  double worst = 0;
  wavefront(
      grid.block(), grid.halo(), stages,
      [&](int s, int k, int j0, int j1) { fused.rows(s, k, j0, j1); },
      [&](int) { grid.halo().exchange(fused.x.data()); },
      [&](int k) {
        EXPECT_EQ(k, finished++);  // every plane once, in order
        worst = std::max(worst, difference(grid.block(), fused.x, expected, k));
      });
  EXPECT_EQ(finished, planes);
  EXPECT_LE(worst, 1e-13) << D << "-D, " << stages << " stages, cells " << mesh.cells[1] << " x "
                          << mesh.cells[D - 1] << ", periodic " << mesh.periodic[1]
                          << mesh.periodic[D - 1];
  for_cells(grid.block(), 1, [&](const Index<D>& c) {  // the exchanges left the ghosts current
    const long p = grid.block().at(c);
    EXPECT_NEAR(fused.x[p], expected[p], 1e-13);
  });
}

TEST(Wavefront, EqualsStageAfterStageInThickBlocks) {
  for (const int stages : {1, 2, 4})
    for (const bool y : {false, true}) {
      compare(unit_mesh<2>({16, 42}, {true, y}), stages);
      for (const bool z : {false, true}) compare(unit_mesh<3>({18, 36, 36}, {false, y, z}), stages);
    }
}

/// Too few planes or rows for inner ones to be left beside the shell.
TEST(Wavefront, EqualsStageAfterStageInThinBlocks) {
  for (const bool y : {false, true}) {
    compare(unit_mesh<2>({16, 6}, {false, y}), 5);
    for (const bool z : {false, true}) {
      compare(unit_mesh<3>({16, 6, 6}, {true, y, z}), 5);
      compare(unit_mesh<3>({16, 40, 6}, {false, y, z}), 5);
      compare(unit_mesh<3>({16, 6, 40}, {false, y, z}), 5);
    }
  }
}

TEST(Wavefront, NoStagesOnlyFinishes) { compare(unit_mesh<3>({16, 6, 6}, {false, true, true}), 0); }

}  // namespace
}  // namespace washtub
