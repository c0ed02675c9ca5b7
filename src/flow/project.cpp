#include <algorithm>
#include <cmath>

#include "flow/flow.hpp"
#include "grid/wavefront.hpp"

namespace washtub {

template <int D>
void Flow<D>::provisional(double dt, Components& out) const {
  const auto& block = grid_.block();
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j) {
      const auto range = multigrid_.live(j, k);
      const int begin = range.begin, end = range.end;
      const long r = block.row(j, k);
      const double* p = multigrid_.pressure().data() + r;
      for (int d = 0; d < D; ++d) {
        const double *u = u_[d].data() + r, *f = f_[d].data() + r;
        const float* open = openings_.open[d] + r;
        double* __restrict__ o = out[d].data() + r;
        const long s = d == 0 ? 1 : block.stride[d];
        const double a = dt / density_, per_h = 1 / grid_.mesh().h[d];
        std::copy_n(u, begin, o);
        std::copy(u + end, u + block.width(), o + end);
#pragma omp simd
        for (int i = begin; i < end; ++i)
          o[i] = u[i] + a * open[i] * (f[i] - per_h * (p[i] - p[i - s]));
      }
    }
}

/// u += dt/rho f on the open faces of a row; returns the largest speed then.
template <int D>
double Flow<D>::add_force_row(int j, int k, double dt) {
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long r = grid_.block().row(j, k);
  double fastest = 0, strongest = 0;
  for (int d = 0; d < D; ++d) {
    double* u = u_[d].data() + r;
    const double* f = f_[d].data() + r;
    const float* open = openings_.open[d] + r;
#pragma omp simd reduction(max : fastest, strongest)
    for (int i = begin; i < end; ++i) {
      strongest = std::max(strongest, std::abs(f[i]));
      u[i] += dt / density_ * open[i] * f[i];
      fastest = std::max(fastest, std::abs(u[i]));
    }
    grid_.halo().wrap_row(u);
  }
  forced_ = forced_ || strongest > 0;
  return fastest;
}

/// Extrapolated after three steps without a flipped face, kept after two, else zero, since a flip
/// changes the pressure by O(1/dt). Where the step is projected again the pressure is its own.
template <int D>
typename Flow<D>::Guess Flow<D>::first_guess() const {
  if (projected_) return {1, 0, true};
  if (steps_since_flip_ >= 3) return {2, -1, false};
  return {steps_since_flip_ == 2 ? 1.0 : 0.0, 0, false};
}

/// Source -div u / dt of the pressure in a row, and the first guess.
template <int D>
void Flow<D>::start_pressure_row(int j, int k, double dt, const Guess& guess) {
  const auto& block = grid_.block();
  const auto& h = grid_.mesh().h;
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long r = block.row(j, k);
  const double *ux = u_[0].data() + r, *uy = u_[1].data() + r, *uz = u_[D - 1].data() + r;
  const long sy = block.stride[1], sz = block.stride[D - 1];
  const double ix = 1 / (h[0] * dt), iy = 1 / (h[1] * dt), iz = 1 / (h[D - 1] * dt);
  const float* live = multigrid_.inverse_diagonal() + r;
  double* __restrict__ b = multigrid_.source().data() + r;
  double* __restrict__ p = multigrid_.pressure().data() + r;
  double* __restrict__ old = pressure_before_.data() + r;
#pragma omp simd
  for (int i = begin; i < end; ++i) {
    double divergence = (ux[i + 1] - ux[i]) * ix + (uy[i + sy] - uy[i]) * iy;
    if constexpr (D == 3) divergence += (uz[i + sz] - uz[i]) * iz;
    const double on = live[i] > 0 ? 1.0 : 0.0;
    b[i] = -on * divergence;
    const double last = p[i];
    p[i] = on * (guess.last * last + guess.before * old[i]);
    old[i] = guess.keep_before ? old[i] : last;
  }
}

/// u -= dt/rho grad p on the faces of a row, with the largest speeds and the kinetic energy.
template <int D>
void Flow<D>::correct_row(int j, int k, double dt, Report& report) {
  const auto& block = grid_.block();
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long r = block.row(j, k);
  const double* p = multigrid_.pressure().data() + r;
  double* __restrict__ rate = row_buffer_.data();
  for (int i = begin; i < end; ++i) rate[i] = 0;
  for (int d = 0; d < D; ++d) {
    double* u = u_[d].data() + r;
    const float* open = openings_.open[d] + r;
    const long s = d == 0 ? 1 : block.stride[d];
    const double g = dt / (density_ * grid_.mesh().h[d]), per_h = 1 / grid_.mesh().h[d];
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

template <int D>
typename Flow<D>::Report Flow<D>::project(double dt, double tolerance, int max_cycles) {
  const auto& block = grid_.block();
  const auto& parallel = grid_.parallel();
  if (!projected_) ++steps_since_flip_;
  const Guess guess = first_guess();
  forced_ = false;
  projected_ = true;
  double speed = std::max(speed_, passing_.fastest_inflow());
  wavefront(
      block, grid_.halo(), 1,
      [&](int, int k, int j0, int j1) {
        for (int j = j0; j < j1; ++j) speed = std::max(speed, add_force_row(j, k, dt));
      },
      [&](int) { exchange_velocity(); },
      [&](int k) {
        for (int j = 0; j < block.rows(); ++j) start_pressure_row(j, k, dt, guess);
      });

  forced_ = parallel.any(forced_);
  speed = std::max(parallel.max(speed), 1e-30);
  const double scale = grid_.mesh().h.maxCoeff() / speed;
  Report report;
  report.pressure = multigrid_.solve(tolerance / (scale * dt), max_cycles);
  report.divergence = report.pressure.residual * dt * scale;
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j) correct_row(j, k, dt, report);
  refresh_ghosts();
  report.speed = parallel.max(report.speed);
  report.courant = parallel.max(report.courant);
  report.kinetic = 0.5 * density_ * grid_.mesh().cell_volume() * parallel.sum(report.kinetic);
  speed_ = report.speed;
  return report;
}

template class Flow<2>;
template class Flow<3>;

}  // namespace washtub
