#include "flow/projection.hpp"

#include <algorithm>
#include <cmath>

#include "base/tally.hpp"
#include "grid/wavefront.hpp"

namespace washtub {

namespace {

constexpr double most_over_rms = 100;  // how far a single cell may be from the root mean square

}  // namespace

template <int D>
Projection<D>::Projection(FlowFields<D>& water)
    : water_(water),
      multigrid_(water.grid, water.density, water.openings.open),
      before_(water.grid.make_field()),
      row_buffer_(static_cast<std::size_t>(water.grid.block().width()) + 16) {}

template <int D>
void Projection<D>::openings_changed(int k0, int k1, bool flipped) {
  multigrid_.update(k0, k1);
  multigrid_.clear_solid(multigrid_.pressure(), k0, k1);
  if (flipped) return warm_start_.flip();
  start_new_cells(multigrid_.pressure(), k0, k1);
  start_new_cells(before_, k0, k1);
}

/// Cells of the planes [k0, k1) in which water now is, without a pressure yet, take the mean of
/// those around that had one, each by how open the face between is. Ghosts are current on return.
template <int D>
void Projection<D>::start_new_cells(Field& pressure, int k0, int k1) {
  const auto& block = water_.grid.block();
  const float* live = multigrid_.inverse_diagonal();
  double* means = multigrid_.source().data();  // not in use until the projection
  const auto for_new_cells = [&](auto&& visit) {
    for (int k = k0; k < k1; ++k)
      for (int j = 0; j < block.rows(); ++j) {
        const auto range = multigrid_.live(j, k);
        const long row = block.row(j, k);
        for (long c = row + range.begin; c < row + range.end; ++c)
          if (live[c] > 0 && pressure[c] == 0) visit(c);
      }
  };
  water_.grid.halo().exchange(pressure.data());
  for_new_cells([&](long c) { means[c] = mean_around(pressure, c); });
  for_new_cells([&](long c) { pressure[c] = means[c]; });
  water_.grid.halo().exchange(pressure.data());
}

template <int D>
double Projection<D>::mean_around(const Field& pressure, long c) const {
  double sum = 0, weights = 0;
  for (int d = 0; d < D; ++d) {
    const long s = water_.grid.block().stride[d];
    const double per_area = 1 / std::pow(water_.grid.mesh().h[d], 2);
    for (const auto& [face, other] : {std::pair{c, c - s}, std::pair{c + s, c + s}}) {
      if (pressure[other] == 0) continue;
      const double weight = per_area * water_.openings.open[d][face];
      sum += weight * pressure[other];
      weights += weight;
    }
  }
  return weights > 0 ? sum / weights : 0;
}

/// u += dt/rho f on the open faces of a row. Where a wall lies nearer than a cell, the water
/// between takes the share of the force that its passage is of the cell; the rest is the wall's.
template <int D>
void Projection<D>::add_force_row(int j, int k, double dt, Extremes& largest) {
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long r = water_.grid.block().row(j, k);
  const double a = dt / water_.density;
  double fastest = 0, strongest = 0;
  for (int d = 0; d < D; ++d) {
    double* u = water_.u[d].data() + r;
    const double* f = water_.f[d].data() + r;
    const float* open = water_.openings.open[d] + r;
#pragma omp simd reduction(max : fastest, strongest)
    for (int i = begin; i < end; ++i) {
      strongest = std::max(strongest, std::abs(f[i]));
      u[i] += a * open[i] * f[i];
      fastest = std::max(fastest, std::abs(u[i]));
    }
    if (const auto* held = water_.openings.held[d])
      held->for_row(water_.grid.block().row_index(j, k), [&](const HeldFace& face, int) {
        u[face.place] -= a * (1 - face.passage) * open[face.place] * f[face.place];
      });
    water_.grid.halo().wrap_row(u);
  }
  largest.speed = std::max(largest.speed, fastest);
  largest.force = std::max(largest.force, strongest);
}

/// Source -div u / dt of the pressure in a row, and the first guess.
template <int D>
void Projection<D>::start_row(int j, int k, double dt, const WarmStart::Guess& guess, bool again) {
  const auto& block = water_.grid.block();
  const auto& h = water_.grid.mesh().h;
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long r = block.row(j, k);
  const double *ux = water_.u[0].data() + r, *uy = water_.u[1].data() + r,
               *uz = water_.u[D - 1].data() + r;
  const long sy = block.stride[1], sz = block.stride[D - 1];
  const double ix = 1 / (h[0] * dt), iy = 1 / (h[1] * dt), iz = 1 / (h[D - 1] * dt);
  const float* live = multigrid_.inverse_diagonal() + r;
  double* __restrict__ b = multigrid_.source().data() + r;
  double* __restrict__ p = multigrid_.pressure().data() + r;
  double* __restrict__ old = before_.data() + r;
#pragma omp simd
  for (int i = begin; i < end; ++i) {
    double divergence = (ux[i + 1] - ux[i]) * ix + (uy[i + sy] - uy[i]) * iy;
    if constexpr (D == 3) divergence += (uz[i + sz] - uz[i]) * iz;
    const double on = live[i] > 0 ? 1.0 : 0.0;
    b[i] = -on * divergence;
    const double last = p[i];
    p[i] = on * (guess.last * last + guess.before * old[i]);
    old[i] = again ? old[i] : last;
  }
}

/// u -= dt/rho grad p on the faces of a row, with the largest speeds and the kinetic energy.
template <int D>
void Projection<D>::correct_row(int j, int k, double dt, Report& report) {
  const auto& block = water_.grid.block();
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long r = block.row(j, k);
  const double* p = multigrid_.pressure().data() + r;
  double* __restrict__ rate = row_buffer_.data();
  for (int i = begin; i < end; ++i) rate[i] = 0;
  for (int d = 0; d < D; ++d) {
    double* u = water_.u[d].data() + r;
    const float* open = water_.openings.open[d] + r;
    const long s = d == 0 ? 1 : block.stride[d];
    const double g = dt / (water_.density * water_.grid.mesh().h[d]),
                 per_h = 1 / water_.grid.mesh().h[d];
    double fastest = 0, squares = 0;
#pragma omp simd reduction(max : fastest) reduction(+ : squares)
    for (int i = begin; i < end; ++i) {
      u[i] -= g * open[i] * (p[i] - p[i - s]);
      const double a = std::abs(u[i]);
      rate[i] += a * per_h;
      fastest = std::max(fastest, a);
      squares += open[i] * u[i] * u[i];
    }
    report.speed = std::max(report.speed, fastest);
    report.kinetic += squares;
  }
  double courant = 0;
#pragma omp simd reduction(max : courant)
  for (int i = begin; i < end; ++i) courant = std::max(courant, rate[i]);
  report.courant = std::max(report.courant, courant);
}

/// Adds the force and writes down the pressure problem; returns the largest speed that the water
/// has or takes up.
template <int D>
double Projection<D>::start(double dt, bool again) {
  const auto& grid = water_.grid;
  if (!again) warm_start_.next_step();
  const WarmStart::Guess guess = again ? WarmStart::Guess{1, 0} : warm_start_.guess();
  Extremes largest{std::max(water_.speed, water_.passing.fastest_inflow()), 0};
  wavefront(
      grid.block(), grid.halo(), 1,
      [&](int, int k, int j0, int j1) {
        for (int j = j0; j < j1; ++j) add_force_row(j, k, dt, largest);
      },
      [&](int) { water_.exchange(); },
      [&](int k) {
        for (int j = 0; j < grid.block().rows(); ++j) start_row(j, k, dt, guess, again);
      });
  Tally tally{{}, {largest.speed, largest.force}};
  combine(grid.parallel(), tally);
  warm_start_.set_forced(tally.max[1] > 0);
  return tally.max[0];
}

template <int D>
void Projection<D>::correct(double dt, Report& report) {
  const auto& block = water_.grid.block();
  const auto& parallel = water_.grid.parallel();
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j) correct_row(j, k, dt, report);
  water_.from_passage();
  water_.refresh_ghosts();
  Tally tally{{report.kinetic}, {report.speed, report.courant}};
  combine(parallel, tally);
  report.speed = tally.max[0];
  report.courant = tally.max[1];
  report.kinetic = 0.5 * water_.density * water_.grid.mesh().cell_volume() * tally.sum[0];
}

template <int D>
typename Projection<D>::Report Projection<D>::project(double dt, const Accuracy& accuracy,
                                                      bool again) {
  const double speed = std::max(start(dt, again), 1e-30);
  const double scale = water_.grid.mesh().h.maxCoeff() / speed;
  Report report;
  const double rms = accuracy.divergence / (scale * dt);
  report.pressure = multigrid_.solve({most_over_rms * rms, rms}, accuracy.max_cycles);
  report.divergence =
      std::max(report.pressure.rms, report.pressure.residual / most_over_rms) * dt * scale;
  correct(dt, report);
  water_.speed = report.speed;
  return report;
}

template <int D>
void Projection<D>::restart() {
  multigrid_.pressure().fill(0);
  before_.fill(0);
  warm_start_ = {};
}

template <int D>
void Projection<D>::state(Archive& archive) {
  archive.grid("pressure", multigrid_.pressure(), water_.grid.part());
  archive.grid("before", before_, water_.grid.part());
  archive.value("warm start", warm_start_);
  if (!archive.reading()) return;
  multigrid_.update();
  water_.grid.halo().exchange(multigrid_.pressure().data());
}

template class Projection<2>;
template class Projection<3>;

}  // namespace washtub
