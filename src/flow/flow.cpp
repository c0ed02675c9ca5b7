#include "flow/flow.hpp"

#include <algorithm>
#include <cmath>

#include "grid/wavefront.hpp"

namespace washtub {
namespace {

constexpr double viscous_accuracy = 1e-5;  // of the viscous solve, relative to the step's change

/// Optimal over-relaxation of the viscous sweeps and how many of them reach viscous_accuracy.
struct Relaxation {
  double omega = 1;
  int sweeps = 2;
};

Relaxation relaxation(double coupling) {
  const double jacobi = coupling / (1 + coupling);
  Relaxation r;
  r.omega = 2 / (1 + std::sqrt(1 - jacobi * jacobi));
  if (r.omega > 1 + 1e-9)
    r.sweeps = std::max(
        2, 1 + static_cast<int>(std::ceil(std::log(viscous_accuracy) / std::log(r.omega - 1))));
  return r;
}

template <int D>
std::array<double*, D> pointers(std::array<Field, D>& fields) {
  std::array<double*, D> p;
  for (int d = 0; d < D; ++d) p[d] = fields[d].data();
  return p;
}

}  // namespace

template <int D>
Flow<D>::Flow(const Grid<D>& grid, double density, double viscosity,
              const std::array<std::array<Side<D>, 2>, D>& sides, const Openings<D>& openings)
    : grid_(grid),
      density_(density),
      viscosity_(viscosity),
      sides_(grid, sides),
      openings_(openings),
      multigrid_(grid, density, openings.open),
      pressure_before_(grid.make_field()) {
  for (int d = 0; d < D; ++d) {
    u_[d] = grid.make_field();
    f_[d] = grid.make_field();
    rhs_[d] = grid.make_field();
    convection_[d] = grid.make_field();
    if (openings.smooth) target_[d] = grid.make_field();
  }
  row_buffer_.resize(static_cast<std::size_t>(grid.block().width()) + 16);
  for (int c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < row_buffer_.size(); ++i)
      colour_[c].push_back(static_cast<int>(i & 1) == c ? 1.0 : 0.0);
  refresh_ghosts();
}

template <int D>
void Flow<D>::exchange_velocity() {
  const auto u = pointers<D>(u_);
  grid_.halo().exchange(std::span<double* const>(u));
}

template <int D>
void Flow<D>::refresh_ghosts() {
  exchange_velocity();
  for (int c = 0; c < D; ++c) sides_.mirror(c, u_[c].data());
}

template <int D>
void Flow<D>::openings_changed(int k0, int k1, bool flipped) {
  multigrid_.update(k0, k1);
  if (flipped) steps_since_flip_ = -1;
  const auto& block = grid_.block();
  for (int k = k0; k < k1; ++k)
    for (int j = 0; j < block.rows(); ++j) {  // no pressure is left behind in cells now solid
      const auto [begin, end] = multigrid_.live(j, k);
      double* p = multigrid_.pressure().data() + block.row(j, k);
      std::fill_n(p, begin, 0.0);
      std::fill(p + end, p + block.width(), 0.0);
    }
}

/// Right-hand side of the viscous solve for component c of one row:
///   u + dt (now N(u^n) + before N(u^{n-1})) + half of the viscous term,
/// N = -div(u u) with arithmetic means on the edges of each momentum cell.
template <int D>
template <int c>
void Flow<D>::predict_row(int j, int k, double now, double before) {
  const auto& block = grid_.block();
  const auto [begin, end] = multigrid_.live(j, k);
  const long p = block.row(j, k);
  std::array<const double*, D> u;
  std::array<long, D> s = block.stride;
  s[0] = 1;
  std::array<double, D> q;
  for (int d = 0; d < D; ++d) {
    u[d] = u_[d].data() + p;
    q[d] = 0.25 / grid_.mesh().h[d];
  }
  const auto& nu = diffusion_;
  double* __restrict__ convection = convection_[c].data() + p;
  double* __restrict__ rhs = rhs_[c].data() + p;
  const double* v = u[c];
  const auto flux = [&](auto axis, int i) {
    constexpr int d = axis;
    const long t = s[d];
    if constexpr (d == c) {
      const double up = v[i] + v[i + t], down = v[i - t] + v[i];
      return q[d] * (up * up - down * down);
    } else {
      const double* w = u[d];
      return q[d] * ((w[i - s[c] + t] + w[i + t]) * (v[i] + v[i + t]) -
                     (w[i - s[c]] + w[i]) * (v[i - t] + v[i]));
    }
  };
  using std::integral_constant;
#pragma omp simd
  for (int i = begin; i < end; ++i) {
    double n = flux(integral_constant<int, 0>{}, i) + flux(integral_constant<int, 1>{}, i);
    double diffusion =
        nu[0] * (v[i + 1] - 2 * v[i] + v[i - 1]) + nu[1] * (v[i + s[1]] - 2 * v[i] + v[i - s[1]]);
    if constexpr (D == 3) {
      n += flux(integral_constant<int, D - 1>{}, i);
      diffusion += nu[D - 1] * (v[i + s[D - 1]] - 2 * v[i] + v[i - s[D - 1]]);
    }
    rhs[i] = v[i] + diffusion - now * n + before * convection[i];
    convection[i] = -n;
  }
}

/// One colour of a Gauss-Seidel sweep for (1 - dt nu/2 laplace) u = rhs on a row; closed faces keep
/// u_o, partly open ones mix both as Eq. (9) does with equal diagonals.
template <int D>
void Flow<D>::relax_row(int c, int j, int k, int colour, double omega) {
  const auto& block = grid_.block();
  const auto [begin, end] = multigrid_.live(j, k);
  const long p = block.row(j, k);
  double* x = u_[c].data() + p;
  const double* rhs = rhs_[c].data() + p;
  const float* open = openings_.open[c] + p;
  const double* on = colour_[(block.parity(j, k) + colour) & 1].data();
  const long sy = block.stride[1], sz = block.stride[D - 1];
  const auto nu = diffusion_;
  double diagonal = 1;
  for (int d = 0; d < D; ++d) diagonal += 2 * nu[d];
  const double weight = omega / diagonal;
  double* __restrict__ fresh = row_buffer_.data();
  const auto momentum = [&](int i) {
    const double o = x[i];
    double r = rhs[i] - o + nu[0] * (x[i + 1] - o + x[i - 1] - o) +
               nu[1] * (x[i + sy] - o + x[i - sy] - o);
    if constexpr (D == 3) r += nu[D - 1] * (x[i + sz] - o + x[i - sz] - o);
    return r;
  };
  if (openings_.smooth) {
    const double* target = target_[c].data() + p;
#pragma omp simd
    for (int i = begin; i < end; ++i)
      fresh[i] = x[i] + on[i] * (open[i] * weight * momentum(i) +
                                 (1 - open[i]) * omega * (target[i] - x[i]));
  } else {
#pragma omp simd
    for (int i = begin; i < end; ++i) fresh[i] = x[i] + on[i] * weight * open[i] * momentum(i);
  }
#pragma omp simd
  for (int i = begin; i < end; ++i) x[i] = fresh[i];
}

template <int D>
void Flow<D>::predict(double dt) {
  double coupling = 0;
  for (int d = 0; d < D; ++d) {
    diffusion_[d] = viscosity_ / density_ * dt / (2 * grid_.mesh().h[d] * grid_.mesh().h[d]);
    coupling += 2 * diffusion_[d];
  }
  const double ratio = last_step_ > 0 ? dt / last_step_ : 0;
  const double now = dt * (1 + 0.5 * ratio), before = -0.5 * dt * ratio;
  last_step_ = dt;
  const Relaxation relax = relaxation(coupling);
  exchange_velocity();  // solids may have moved since, and with them the faces they close
  const auto stage = [&](int s, int k, int j0, int j1) {
    for (int j = j0; j < j1; ++j) {
      if (s == 0) {
        predict_row<0>(j, k, now, before);
        predict_row<1>(j, k, now, before);
        if constexpr (D == 3) predict_row<2>(j, k, now, before);
        continue;
      }
      for (int c = 0; c < D; ++c) {
        relax_row(c, j, k, (s - 1) & 1, relax.omega);
        sides_.mirror_row(c, u_[c].data(), j, k);
        grid_.halo().wrap_row(u_[c].data() + grid_.block().row(j, k));
      }
    }
  };
  wavefront(
      grid_.block(), grid_.halo(), 1 + 2 * relax.sweeps, stage,
      [&](int s) {
        if (s > 0) exchange_velocity();
      },
      [](int) {});
}

template <int D>
void Flow<D>::provisional(double dt, Components& out) const {
  const auto& block = grid_.block();
  for (int k = 0; k < block.planes(); ++k)
    for (int j = 0; j < block.rows(); ++j) {
      const auto [begin, end] = multigrid_.live(j, k);
      const long r = block.row(j, k);
      const double* p = multigrid_.pressure().data() + r;
      for (int d = 0; d < D; ++d) {
        const double *u = u_[d].data() + r, *f = f_[d].data() + r;
        const float* open = openings_.open[d] + r;
        double* __restrict__ o = out[d].data() + r;
        const long s = d == 0 ? 1 : block.stride[d];
        const double a = dt / density_, per_h = 1 / grid_.mesh().h[d];
#pragma omp simd
        for (int i = begin; i < end; ++i)
          o[i] = u[i] + a * open[i] * (f[i] - per_h * (p[i] - p[i - s]));
      }
    }
}

/// u -= dt/rho grad p on the faces of a row, with the largest speeds and the kinetic energy.
template <int D>
void Flow<D>::correct_row(int j, int k, double dt, Report& report) {
  const auto& block = grid_.block();
  const auto [begin, end] = multigrid_.live(j, k);
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
  const auto& h = grid_.mesh().h;
  ++steps_since_flip_;
  const double again = steps_since_flip_ >= 3 ? 2.0 : steps_since_flip_ == 2 ? 1.0 : 0.0;
  const double before = steps_since_flip_ >= 3 ? -1.0 : 0.0;
  double speed = speed_;

  const auto add_force = [&](int, int k, int j0, int j1) {
    for (int j = j0; j < j1; ++j) {
      const auto [begin, end] = multigrid_.live(j, k);
      const long r = block.row(j, k);
      for (int d = 0; d < D; ++d) {
        double* u = u_[d].data() + r;
        const double* f = f_[d].data() + r;
        const float* open = openings_.open[d] + r;
        double fastest = 0;
#pragma omp simd reduction(max : fastest)
        for (int i = begin; i < end; ++i) {
          u[i] += dt / density_ * open[i] * f[i];
          fastest = std::max(fastest, std::abs(u[i]));
        }
        speed = std::max(speed, fastest);
        grid_.halo().wrap_row(u);
      }
    }
  };
  const auto source = [&](int k) {
    for (int j = 0; j < block.rows(); ++j) {
      const auto [begin, end] = multigrid_.live(j, k);
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
        p[i] = on * (again * last + before * old[i]);
        old[i] = last;
      }
    }
  };
  wavefront(
      block, grid_.halo(), 1, add_force, [&](int) { exchange_velocity(); }, source);

  speed = std::max(parallel.max(speed), 1e-30);
  const double scale = h.maxCoeff() / speed;
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
