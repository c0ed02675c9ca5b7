#include "flow/pressure/multigrid.hpp"

#include <algorithm>
#include <cstring>

#include "flow/pressure/gather.hpp"
#include "grid/wavefront.hpp"

namespace washtub {
namespace {

constexpr float omega = 1.15F;    // over-relaxation of every sweep
constexpr int finest_sweeps = 2;  // after the coarse correction; none before it
constexpr int coarse_sweeps = 1;
constexpr int coarsest_sweeps = 16;
constexpr double stall = 0.5;  // a slower factor twice running calls for Krylov

}  // namespace

template <int D>
Multigrid<D>::Multigrid(const Grid<D>& grid, double density, std::array<const float*, D> open)
    : grid_(grid),
      levels_(coarsen(grid.mesh()).size() + 1),
      problem_{levels_.front(), {}, grid.make_field(), grid.make_field()},
      coarse_open_(levels_.size()),
      first_gathered_(levels_.size()),
      krylov_(grid, problem_) {
  const auto& mesh = grid.mesh();
  auto& finest = levels_.front();
  finest.allocate(grid.block(), mesh.cells, mesh.periodic);
  finest.halo = Halo<D>(grid.comm(), grid.block(), mesh.periodic[0]);
  finest.open = open;
  for (int d = 0; d < D; ++d) {
    problem_.g[d] = 1.0 / (density * mesh.h[d] * mesh.h[d]);
    finest.g[d] = static_cast<float>(problem_.g[d]);
  }

  std::array<int, D> ones, periods{};
  ones.fill(1);
  for (int d = 1; d < D; ++d) periods[d - 1] = mesh.periodic[d];
  MPI_Cart_create(MPI_COMM_SELF, D - 1, ones.data(), periods.data(), 0, &self_);

  const auto hierarchy = coarsen(mesh);
  Block<D> block = grid.block();
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    block = coarse_block(l, hierarchy[l - 1], block);
    make_level(l, hierarchy[l - 1], block, density);
  }
  live_.assign(finest.begin.size(), 0);
  row_sum_.resize(static_cast<std::size_t>(mesh.cells[0]) + 64);
  update();
}

/// What this rank holds of a level: its part, or, from the first gathered level on, all of it.
template <int D>
Block<D> Multigrid<D>::coarse_block(std::size_t l, const Coarsening<D>& level,
                                    const Block<D>& finer) {
  Block<D> part = finer;
  for (int d = 0; d < D; ++d) {
    part.offset[d] /= level.factor[d];
    part.count[d] = coarse_count(part.count[d], level.factor[d]);
  }
  if (!level.gathered || gather_ || grid_.parallel().size() == 1)
    return Block<D>(part.offset, part.count);
  first_gathered_ = l;
  levels_[l].place = part.offset;
  gather_ = std::make_unique<GatherBlocks<D>>(grid_.parallel(), part);
  return Block<D>(Index<D>{}, level.cells);
}

template <int D>
void Multigrid<D>::make_level(std::size_t l, const Coarsening<D>& level, const Block<D>& block,
                              double density) {
  auto& c = levels_[l];
  const bool whole = gather_ || grid_.parallel().size() == 1;
  c.factor = level.factor;
  c.allocate(block, level.cells, grid_.mesh().periodic);
  c.halo = Halo<D>(whole ? self_ : grid_.comm(), block, grid_.mesh().periodic[0]);
  for (int d = 0; d < D; ++d) {
    c.g[d] = static_cast<float>(1.0 / (density * level.h[d] * level.h[d]));
    coarse_open_[l][d] = Storage<float>(static_cast<std::size_t>(block.size));
    c.open[d] = coarse_open_[l][d].data();
  }
}

template <int D>
Multigrid<D>::~Multigrid() {
  MPI_Comm_free(&self_);
}

template <int D>
void Multigrid<D>::update(int k0, int k1) {
  const auto finish = [](auto& level, int a, int b) {
    for (int k = std::max(a, 0); k < std::min(b, level.block.planes()); ++k)
      for (int j = 0; j < level.block.rows(); ++j) finish_row(level, j, k);
  };
  finish(levels_.front(), k0 - 1, k1);
  count_live(k0 - 1, k1);
  clear_solid(levels_.front().x, std::max(k0 - 1, 0), k1);
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    auto& c = levels_[l];
    k0 = k0 / c.factor[D - 1];
    k1 = (k1 + c.factor[D - 1] - 1) / c.factor[D - 1];
    coarsen_open(l, k0, k1);
    if (l == first_gathered_) {
      k0 = 0;
      k1 = c.block.planes();
      for (int d = 0; d < D; ++d) gather_->all(coarse_open_[l][d].data(), c.block);
    }
    c.halo.exchange(coarse_open_[l]);
    finish(c, k0 - 1, k1);
  }
}

template <int D>
void Multigrid<D>::count_live(int k0, int k1) {
  const auto& finest = levels_.front();
  const auto& block = finest.block;
  for (int k = std::max(k0, 0); k < std::min(k1, block.planes()); ++k)
    for (int j = 0; j < block.rows(); ++j) {
      const float* id = finest.inverse_diagonal.data() + block.row(j, k);
      int& live = live_[static_cast<std::size_t>(block.row_index(j, k))];
      live_cells_ -= live;
      live = static_cast<int>(std::count_if(id, id + block.width(), [](float v) { return v > 0; }));
      live_cells_ += live;
    }
}

/// Open fractions of the coarse planes [K0, K1): mean of the fine faces that tile each coarse face;
/// those beyond the last fine cell are closed.
template <int D>
void Multigrid<D>::coarsen_open(std::size_t l, int K0, int K1) {
  const auto &fine = levels_[l - 1], &c = levels_[l];
  const int fx = c.factor[0], fy = D == 3 ? c.factor[1] : 1, fz = c.factor[D - 1];
  const int planes = fine.block.planes(), rows = fine.block.rows(), width = c.block.width();
  for (int K = K0; K < std::min(K1, coarse_count(planes, fz)); ++K)
    for (int J = 0; J < coarse_count(rows, fy); ++J) {
      const long q = c.block.row(J + (D == 3 ? c.place[1] : 0), K + c.place[D - 1]);
      for (int d = 0; d < D; ++d) {
        float* __restrict__ o = coarse_open_[l][d].data() + q;
        const int across_x = d == 0 ? 1 : fx, across_y = D == 3 && d == 1 ? 1 : fy;
        const int across_z = d == D - 1 ? 1 : fz;
        const float weight = 1.0F / static_cast<float>(across_x * across_y * across_z);
        std::fill_n(o, width, 0.0F);
        for (int k = K * fz; k < std::min(K * fz + across_z, planes); ++k)
          for (int j = J * fy; j < std::min(J * fy + across_y, rows); ++j) {
            const float* f = fine.open[d] + fine.block.row(j, k);
            for (int e = 0; e < across_x; ++e) {
              const int whole = e == 0 ? width : fine.block.width() / fx;
              for (int i = 0; i < whole; ++i) o[i] += weight * f[fx * i + e];
            }
          }
      }
    }
}

/// Right-hand side of plane K of the level below l: the mean over the children, missing ones
/// counted as 0, of what add_row(j, k, sum) adds to the sum along a row of level l.
template <int D>
template <class AddRow>
void Multigrid<D>::restrict_plane(std::size_t l, int K, AddRow&& add_row) {
  const auto& fine = levels_[l];
  auto& c = levels_[l + 1];
  const int fx = c.factor[0], fy = D == 3 ? c.factor[1] : 1, fz = c.factor[D - 1];
  const float weight = 1.0F / static_cast<float>(fx * fy * fz);
  float* __restrict__ sum = row_sum_.data();
  const int planes = fine.block.planes(), rows = fine.block.rows();
  for (int J = 0; J < coarse_count(rows, fy); ++J) {
    std::memset(sum, 0, sizeof(float) * static_cast<std::size_t>(fx * c.block.width()));
    for (int k = K * fz; k < std::min((K + 1) * fz, planes); ++k)
      for (int j = J * fy; j < std::min((J + 1) * fy, rows); ++j) add_row(j, k, sum);
    float* __restrict__ o =
        c.b.data() + c.block.row(J + (D == 3 ? c.place[1] : 0), K + c.place[D - 1]);
    const int width = c.block.width();
    if (fx == 1) {
#pragma omp simd
      for (int i = 0; i < width; ++i) o[i] = weight * sum[i];
    } else {
#pragma omp simd
      for (int i = 0; i < width; ++i) o[i] = weight * (sum[2 * i] + sum[2 * i + 1]);
    }
  }
}

template <int D>
void Multigrid<D>::restrict_source(std::size_t l) {
  const auto& fine = levels_[l];
  for (int K = 0; K < coarse_count(fine.block.planes(), levels_[l + 1].factor[D - 1]); ++K)
    restrict_plane(l, K, [&](int j, int k, float* sum) { source_row(fine, j, k, sum); });
}

template <int D>
void Multigrid<D>::gather_source(std::size_t l) {
  if (l == first_gathered_ && gather_) gather_->all(levels_[l].b.data(), levels_[l].block);
}

/// Takes the correction from the level below l (set or add), then sweeps; finish(k) is called once
/// the planes k - 1, k, k + 1 are done.
template <int D>
template <class Finish>
void Multigrid<D>::smooth(std::size_t l, Start start, int sweeps, Finish&& finish) {
  auto& fine = levels_[l];
  const auto& coarse = levels_[l + 1];
  const auto stage = [&](int s, int k, int j0, int j1) {
    for (int j = j0; j < j1; ++j) {
      if (s > 0)
        relax_row(fine, j, k, (s - 1) & 1, omega);
      else if (start == Start::add)
        prolong_row<true>(fine, coarse, j, k);
      else
        prolong_row<false>(fine, coarse, j, k);
      fine.halo.wrap_row(fine.x.data() + fine.block.row(j, k));
    }
  };
  wavefront(
      fine.block, fine.halo, 1 + 2 * sweeps, stage, [&](int) { fine.halo.exchange(fine.x.data()); },
      finish);
}

template <int D>
void Multigrid<D>::solve_coarsest() {
  auto& l = levels_.back();
  l.x.fill(0);
  for (int s = 0; s < 2 * coarsest_sweeps; ++s) {
    for (int k = 0; k < l.block.planes(); ++k)
      for (int j = 0; j < l.block.rows(); ++j) relax_row(l, j, k, s & 1, omega);
    l.halo.exchange(l.x.data());
  }
}

/// x = approximately A^-1 b on a coarse level. A full cycle takes its correction from a full one
/// and then a simple one of the next level (an F-cycle, so that level l is visited l times and
/// needs few messages), a simple one from a simple one alone.
template <int D>
void Multigrid<D>::solve_level(std::size_t l, Cycle cycle) {
  gather_source(l);
  if (l + 1 == levels_.size()) return solve_coarsest();
  const auto& level = levels_[l];
  const int fz = levels_[l + 1].factor[D - 1], planes = level.block.planes();
  const int visits = cycle == Cycle::full && l + 2 < levels_.size() ? 2 : 1;
  restrict_source(l);
  for (int v = 0; v < visits; ++v) {
    solve_level(l + 1, v == 0 ? cycle : Cycle::simple);
    const auto finish = [&](int k) {
      if (v + 1 == visits || (k % fz < fz - 1 && k < planes - 1)) return;
      restrict_plane(l, k / fz, [&](int j, int i, float* sum) { residual_row(level, j, i, sum); });
    };
    smooth(l, v == 0 ? Start::set : Start::add, coarse_sweeps, finish);
  }
}

/// What is left of the problem on the planes that plane K of the first coarse level comes from,
/// to both levels; returns its size on this rank.
template <int D>
ResidualSize Multigrid<D>::take_residual(int K) {
  auto& finest = levels_.front();
  ResidualSize size;
  restrict_plane(0, K, [&](int j, int k, float* sum) {
    size.add(residual_row(problem_, j, k, finest.b.data() + finest.block.row(j, k), sum));
  });
  return size;
}

/// Adds the finest level's correction to a plane of the pressure, ghosts included.
template <int D>
void Multigrid<D>::add_correction(int k) {
  const auto& block = grid_.block();
  const long begin = D == 3 ? block.row(-1, k) : block.row(0, k),
             end = D == 3 ? block.row(block.rows(), k) : block.row(0, k);
  const float* correction = levels_.front().x.data();
  double* x = problem_.x.data();
#pragma omp simd
  for (long p = begin - 1; p < end + block.width() + 1; ++p) x[p] += correction[p];
}

/// Corrects the pressure with what the first coarse level found, and takes the residual, one plane
/// behind; returns its size on this rank.
template <int D>
ResidualSize Multigrid<D>::correct() {
  const int fz = levels_[1].factor[D - 1], last = grid_.block().planes() - 1;
  ResidualSize size;
  const auto take = [&](int k) {
    if (k % fz == fz - 1 || k == last) size.add(take_residual(k / fz));
  };
  smooth(0, Start::set, finest_sweeps, [&](int k) {
    if (k == 0) add_correction(-1);
    add_correction(k);
    if (k == last) add_correction(last + 1);
    if (k > 0) take(k - 1);
    if (k == last) take(last);
  });
  return size;
}

template <int D>
SolveReport Multigrid<D>::solve(const Tolerance& tolerance, int max_cycles) {
  const auto& parallel = grid_.parallel();
  SolveReport report;
  levels_.front().halo.exchange(problem_.x.data());
  ResidualSize size;
  for (int K = 0; K < coarse_count(grid_.block().planes(), levels_[1].factor[D - 1]); ++K)
    size.add(take_residual(K));
  set_residual(report, parallel, size, live_cells_);
  int slow = 0;
  while (!tolerance.met(report) && report.cycles < max_cycles) {
    solve_level(1, Cycle::full);
    const double before = report.residual;
    set_residual(report, parallel, correct(), live_cells_);
    ++report.cycles;
    slow = report.residual > stall * before ? slow + 1 : 0;
    if (slow == 2 && !tolerance.met(report))
      return krylov_.solve([this] { cycle_from_zero(); }, tolerance, report, max_cycles,
                           live_cells_);
  }
  report.converged = tolerance.met(report);
  return report;
}

/// pressure() = approximately A^-1 source(), without ghosts.
template <int D>
void Multigrid<D>::cycle_from_zero() {
  auto& finest = levels_.front();
  std::copy_n(problem_.b.data(), problem_.b.size(), finest.b.data());
  restrict_source(0);
  solve_level(1, Cycle::full);
  smooth(0, Start::set, finest_sweeps, [](int) {});
  std::copy_n(finest.x.data(), finest.x.size(), problem_.x.data());
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace washtub
