#include "flow/pressure/multigrid.hpp"

#include <algorithm>
#include <cstring>

#include "flow/pressure/gather.hpp"
#include "grid/wavefront.hpp"

namespace washtub {
namespace {

constexpr double omega = 1.15;    // over-relaxation of every sweep
constexpr int finest_sweeps = 2;  // after the coarse correction; none before it
constexpr int coarse_sweeps = 1;
constexpr int coarsest_sweeps = 16;
constexpr double stall = 0.5;  // a slower factor twice running calls for Krylov

}  // namespace

template <int D>
Multigrid<D>::Multigrid(const Grid<D>& grid, double density, std::array<const float*, D> open)
    : grid_(grid), krylov_(grid, finest_) {
  const auto& mesh = grid.mesh();
  finest_.allocate(grid.block(), mesh.cells, mesh.periodic);
  finest_.halo = Halo<D>(grid.comm(), grid.block(), mesh.periodic[0]);
  finest_.open = open;
  for (int d = 0; d < D; ++d) finest_.g[d] = 1.0 / (density * mesh.h[d] * mesh.h[d]);

  std::array<int, D> ones, periods{};
  ones.fill(1);
  for (int d = 1; d < D; ++d) periods[d - 1] = mesh.periodic[d];
  MPI_Cart_create(MPI_COMM_SELF, D - 1, ones.data(), periods.data(), 0, &self_);

  const auto hierarchy = coarsen(mesh);
  coarse_.resize(hierarchy.size());
  coarse_open_.resize(hierarchy.size());
  first_gathered_ = hierarchy.size();
  Block<D> block = grid.block();
  for (std::size_t l = 0; l < hierarchy.size(); ++l) {
    block = coarse_block(l, hierarchy[l], block);
    make_level(l, hierarchy[l], block, density);
  }
  live_.assign(finest_.begin.size(), 0);
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
  coarse_[l].place = part.offset;
  gather_ = std::make_unique<GatherBlocks<D>>(grid_.parallel(), part);
  return Block<D>(Index<D>{}, level.cells);
}

template <int D>
void Multigrid<D>::make_level(std::size_t l, const Coarsening<D>& level, const Block<D>& block,
                              double density) {
  auto& c = coarse_[l];
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
  coarse_.clear();
  MPI_Comm_free(&self_);
}

template <int D>
void Multigrid<D>::update(int k0, int k1) {
  const auto finish = [](auto& level, int a, int b) {
    for (int k = std::max(a, 0); k < std::min(b, level.block.planes()); ++k)
      for (int j = 0; j < level.block.rows(); ++j) finish_row(level, j, k);
  };
  finish(finest_, k0 - 1, k1);
  count_live(k0 - 1, k1);
  for (std::size_t l = 0; l < coarse_.size(); ++l) {
    auto& c = coarse_[l];
    k0 = k0 / c.factor[D - 1];
    k1 = (k1 + c.factor[D - 1] - 1) / c.factor[D - 1];
    if (l == 0)
      coarsen_open(finest_, l, k0, k1);
    else
      coarsen_open(coarse_[l - 1], l, k0, k1);
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
  const auto& block = finest_.block;
  for (int k = std::max(k0, 0); k < std::min(k1, block.planes()); ++k)
    for (int j = 0; j < block.rows(); ++j) {
      const float* id = finest_.inverse_diagonal.data() + block.row(j, k);
      int& live = live_[static_cast<std::size_t>(block.row_index(j, k))];
      live_cells_ -= live;
      live = static_cast<int>(std::count_if(id, id + block.width(), [](float v) { return v > 0; }));
      live_cells_ += live;
    }
}

template <int D>
void Multigrid<D>::clear_solid(Field& field, int k0, int k1) const {
  const auto& block = finest_.block;
  for (int k = k0; k < k1; ++k)
    for (int j = 0; j < block.rows(); ++j) {
      const auto [begin, end] = live(j, k);
      double* row = field.data() + block.row(j, k);
      std::fill_n(row, begin, 0.0);
      std::fill(row + end, row + block.width(), 0.0);
    }
}

/// Open fractions of the coarse planes [K0, K1): mean of the fine faces that tile each coarse face;
/// those beyond the last fine cell are closed.
template <int D>
template <class T>
void Multigrid<D>::coarsen_open(const Level<D, T>& fine, std::size_t l, int K0, int K1) {
  auto& c = coarse_[l];
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

/// Mean over the children, missing ones counted as 0, of the residual (or of the right-hand side,
/// where the fine level starts from zero); returns the size of the residual.
template <int D>
template <class T>
ResidualSize Multigrid<D>::restrict_plane(const Level<D, T>& fine, Level<D, float>& c, int K,
                                          bool source) {
  const int fx = c.factor[0], fy = D == 3 ? c.factor[1] : 1, fz = c.factor[D - 1];
  const float weight = 1.0F / static_cast<float>(fx * fy * fz);
  ResidualSize size;
  float* __restrict__ sum = row_sum_.data();
  const int planes = fine.block.planes(), rows = fine.block.rows();
  for (int J = 0; J < coarse_count(rows, fy); ++J) {
    std::memset(sum, 0, sizeof(float) * static_cast<std::size_t>(fx * c.block.width()));
    for (int k = K * fz; k < std::min((K + 1) * fz, planes); ++k)
      for (int j = J * fy; j < std::min((J + 1) * fy, rows); ++j) {
        if (source)
          source_row(fine, j, k, sum);
        else
          size.add(residual_row(fine, j, k, sum));
      }
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
  return size;
}

template <int D>
template <class T>
void Multigrid<D>::restrict_source(const Level<D, T>& fine, std::size_t coarse) {
  const int planes = coarse_count(fine.block.planes(), coarse_[coarse].factor[D - 1]);
  for (int K = 0; K < planes; ++K) restrict_plane(fine, coarse_[coarse], K, true);
}

/// Takes the coarse correction (set or add), then sweeps; with `residual` restricts what is left
/// and returns its size on this rank.
template <int D>
template <class T>
ResidualSize Multigrid<D>::smooth(Level<D, T>& fine, std::size_t coarse, Start start, int sweeps,
                                  bool residual) {
  auto& c = coarse_[coarse];
  const int first = start == Start::keep ? 0 : 1;
  const int fz = c.factor[D - 1];
  ResidualSize size;
  const auto stage = [&](int s, int k, int j0, int j1) {
    for (int j = j0; j < j1; ++j) {
      if (s < first) {
        if (start == Start::add)
          prolong_row<true>(fine, c, j, k);
        else
          prolong_row<false>(fine, c, j, k);
      } else {
        relax_row(fine, j, k, (s - first) & 1, static_cast<T>(omega));
      }
      fine.halo.wrap_row(fine.x.data() + fine.block.row(j, k));
    }
  };
  wavefront(
      fine.block, fine.halo, first + 2 * sweeps, stage,
      [&](int) { fine.halo.exchange(fine.x.data()); },
      [&](int k) {
        if (residual && (k % fz == fz - 1 || k == fine.block.planes() - 1))
          size.add(restrict_plane(fine, c, k / fz, false));
      });
  return size;
}

template <int D>
void Multigrid<D>::gather_source(std::size_t l) {
  if (l == first_gathered_ && gather_) gather_->all(coarse_[l].b.data(), coarse_[l].block);
}

template <int D>
void Multigrid<D>::solve_coarsest(Level<D, float>& l) {
  l.x.fill(0);
  for (int s = 0; s < 2 * coarsest_sweeps; ++s) {
    for (int k = 0; k < l.block.planes(); ++k)
      for (int j = 0; j < l.block.rows(); ++j) relax_row(l, j, k, s & 1, static_cast<float>(omega));
    l.halo.exchange(l.x.data());
  }
}

/// x = approximately A^-1 b on a coarse level. A full cycle takes its correction from a full one
/// and then a simple one of the next level (an F-cycle, so that level l is visited l + 1 times and
/// needs few messages), a simple one from a simple one alone.
template <int D>
void Multigrid<D>::solve_level(std::size_t l, Cycle cycle) {
  gather_source(l);
  auto& level = coarse_[l];
  if (l + 1 == coarse_.size()) return solve_coarsest(level);
  const int visits = cycle == Cycle::full && l + 2 < coarse_.size() ? 2 : 1;
  restrict_source(level, l + 1);
  for (int v = 0; v < visits; ++v) {
    solve_level(l + 1, v == 0 ? cycle : Cycle::simple);
    smooth(level, l + 1, v == 0 ? Start::set : Start::add, coarse_sweeps, v + 1 < visits);
  }
}

template <int D>
SolveReport Multigrid<D>::solve(const Tolerance& tolerance, int max_cycles) {
  const auto& parallel = grid_.parallel();
  SolveReport report;
  finest_.halo.exchange(finest_.x.data());
  set_residual(report, parallel, smooth(finest_, 0, Start::keep, 0, true), live_cells_);
  int slow = 0;
  while (!tolerance.met(report) && report.cycles < max_cycles) {
    solve_level(0, Cycle::full);
    const double before = report.residual;
    set_residual(report, parallel, smooth(finest_, 0, Start::add, finest_sweeps, true),
                 live_cells_);
    ++report.cycles;
    slow = report.residual > stall * before ? slow + 1 : 0;
    if (slow == 2 && !tolerance.met(report))
      return krylov_.solve([this] { cycle_from_zero(); }, tolerance, report, max_cycles,
                           live_cells_);
  }
  report.converged = tolerance.met(report);
  return report;
}

/// pressure() = approximately A^-1 source().
template <int D>
void Multigrid<D>::cycle_from_zero() {
  restrict_source(finest_, 0);
  solve_level(0, Cycle::full);
  smooth(finest_, 0, Start::set, finest_sweeps, false);
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace washtub
