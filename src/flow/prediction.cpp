#include "flow/prediction.hpp"

#include <algorithm>
#include <cmath>

#include "grid/wavefront.hpp"

namespace washtub {
namespace {

constexpr double most_growth = 4;  // of the step, over which the convection is extrapolated
constexpr int odd_sweeps =
    3;  // times as many where neighbours of one colour meet: measured, to 1e-5
constexpr double viscous_accuracy = 1e-5;  // of the viscous solve, relative to the step's change
constexpr double enough = 0.03;  // left of the change on the grid scale; on waves of twelve cells
                                 // it is less than a hundredth of that

/// The viscous solve: two explicit steps, the second one with the viscosity of the first, which
/// leave (2 diffusion number)^2 of the step's change on the grid scale, and, where that is too
/// much, red-black sweeps with optimal over-relaxation.
struct Relaxation {
  double step = 1;  ///< share taken of the explicit steps, for stability
  double omega = 1;
  int sweeps = 0;
};

Relaxation relaxation(double diffusion_number) {
  const double jacobi = diffusion_number / (1 + diffusion_number);
  Relaxation r;
  r.step = std::min(1.0, 2 / (1 + 2 * diffusion_number));
  r.omega = 2 / (1 + std::sqrt(1 - jacobi * jacobi));
  const double left = std::min(1.0, std::pow(2 * diffusion_number, 2));
  if (left > enough)
    r.sweeps =
        1 + static_cast<int>(std::ceil(std::log(viscous_accuracy / left) / std::log(r.omega - 1)));
  return r;
}

/// Share of its step that a held face takes, with its place in its row.
constexpr auto everywhere = [](int) { return 1.0; };

}  // namespace

template <int D>
Prediction<D>::Prediction(FlowFields<D>& water, const Multigrid<D>& multigrid)
    : water_(water), multigrid_(multigrid) {
  for (int d = 0; d < D; ++d) {
    rhs_[d] = water.grid.make_field();
    guess_[d] = water.grid.make_field();
    convection_[d] = water.grid.make_field();
  }
  row_buffer_.resize(static_cast<std::size_t>(water.grid.block().width()) + 16);
  for (int c = 0; c < 2; ++c)
    for (std::size_t i = 0; i < row_buffer_.size(); ++i)
      colour_[c].push_back(static_cast<int>(i & 1) == c ? 1.0 : 0.0);
  const auto& mesh = water.grid.mesh();
  for (int d = 0; d < D; ++d) odd_[d] = mesh.periodic[d] && mesh.cells[d] % 2 == 1;
}

template <int D>
void Prediction<D>::openings_changed(int k0, int k1) {
  for (auto& c : convection_) multigrid_.clear_solid(c, k0, k1);
}

/// Right-hand side of the viscous solve for component c of one row:
///   u + now N(u^n) + before N(u^{n-1}) - push grad p + half of the viscous term,
/// N = -div(u u) with arithmetic means on the edges of each momentum cell; and a guess of its
/// solution, weights.step times the explicit step away from u^n.
template <int D>
template <int c, bool pushed>
void Prediction<D>::start_row(int j, int k, const Weights& weights) {
  const auto& block = water_.grid.block();
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long p = block.row(j, k);
  std::array<const double*, D> u;
  std::array<long, D> s = block.stride;
  s[0] = 1;
  std::array<double, D> q;
  for (int d = 0; d < D; ++d) {
    u[d] = water_.u[d].data() + p;
    q[d] = 0.25 / water_.grid.mesh().h[d];
  }
  const auto& nu = diffusion_;
  double* __restrict__ convection = convection_[c].data() + p;
  double* __restrict__ rhs = rhs_[c].data() + p;
  double* __restrict__ guess = guess_[c].data() + p;
  const float* open = water_.openings.open[c] + p;
  const double* v = u[c];
  const double now = weights.now, before = weights.before, step = weights.step;
  const double slope = weights.push / water_.grid.mesh().h[c];
  const double* pressure = multigrid_.pressure().data() + p;
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
    double sum = v[i] + diffusion - now * n + before * convection[i];
    if constexpr (pushed) sum -= slope * (pressure[i] - pressure[i - s[c]]);
    rhs[i] = sum;
    guess[i] = v[i] + step * open[i] * (sum + diffusion - v[i]);
    convection[i] = -n;
  }
  std::copy(v - 1, v + begin, guess - 1);
  std::copy(v + end, v + block.width() + 1, guess + end);
}

/// What (1 - dt nu/2 laplace) u = rhs asks for on a row, from the values x of the velocity around.
template <int D>
auto Prediction<D>::momentum(int c, int j, int k, const double* x) const {
  const auto& block = water_.grid.block();
  return [x, rhs = rhs_[c].data() + block.row(j, k), nu = diffusion_, sy = block.stride[1],
          sz = block.stride[D - 1]](int i) {
    const double o = x[i];
    double r = rhs[i] - o + nu[0] * (x[i + 1] - o + x[i - 1] - o) +
               nu[1] * (x[i + sy] - o + x[i - sy] - o);
    if constexpr (D == 3) r += nu[D - 1] * (x[i + sz] - o + x[i - sz] - o);
    return r;
  };
}

/// The faces of a row that are held mix momentum and what they are held to as Eq. (9) does with
/// equal diagonals, from the values x into `fresh`; `share` is that of the step to take.
template <int D>
template <class Share>
void Prediction<D>::relax_held(int c, int j, int k, const double* x, double diagonal, Share&& share,
                               double* fresh) {
  const auto* held = water_.openings.held[c];
  if (!held) return;
  const auto ask = momentum(c, j, k, x);
  held->for_row(water_.grid.block().row_index(j, k), [&](const HeldFace& face, int) {
    const double u = x[face.place], to_wall = face.wall - u;
    const double drag = face.drag * wall_diffusion_;
    const double free = (ask(face.place) + drag * to_wall) / (diagonal + drag);
    fresh[face.place] = u + share(face.place) * ((1 - face.share) * free + face.share * to_wall);
  });
}

template <int D>
void Prediction<D>::start_rows(int j, int k, const Weights& weights) {
  const auto all = [&](auto pushed) {
    start_row<0, pushed>(j, k, weights);
    start_row<1, pushed>(j, k, weights);
    if constexpr (D == 3) start_row<2, pushed>(j, k, weights);
  };
  if (weights.push > 0)
    all(std::true_type());
  else
    all(std::false_type());
  const long p = water_.grid.block().row(j, k);
  for (int c = 0; c < D; ++c)
    relax_held(c, j, k, water_.u[c].data() + p, 1 / weights.step, everywhere, guess_[c].data() + p);
}

/// u += push grad p on the open faces of a row.
template <int D>
void Prediction<D>::take_push_back(int j, int k, double push) {
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long r = water_.grid.block().row(j, k);
  const double* p = multigrid_.pressure().data() + r;
  for (int d = 0; d < D; ++d) {
    double* __restrict__ u = water_.u[d].data() + r;
    const float* open = water_.openings.open[d] + r;
    const long s = water_.grid.block().stride[d];
    const double slope = push / water_.grid.mesh().h[d];
#pragma omp simd
    for (int i = begin; i < end; ++i) u[i] += slope * open[i] * (p[i] - p[i - s]);
  }
}

/// Share of its relaxation that a cell takes which has a neighbour of its own colour along `axis`:
/// the two move at once, and the sweeps converge because their diagonals count that link twice.
template <int D>
double Prediction<D>::clash_share(int axis) const {
  double diagonal = 1;
  for (int d = 0; d < D; ++d) diagonal += 2 * diffusion_[d];
  return diagonal / (diagonal + diffusion_[axis]);
}

/// That share for a row, of all axes but x.
template <int D>
double Prediction<D>::row_share(int j, int k) const {
  const Index<D> cell = water_.grid.block().row_cell(j, k);
  double share = 1;
  for (int d = 1; d < D; ++d)
    if (odd_[d] && (cell[d] == 0 || cell[d] == water_.grid.mesh().cells[d] - 1))
      share *= clash_share(d);
  return share;
}

/// The second explicit step of a row, from the guess to u; closed faces keep u_o.
template <int D>
void Prediction<D>::leave_guess(int c, int j, int k, double step) {
  const auto range = multigrid_.live(j, k);
  const long p = water_.grid.block().row(j, k);
  water_.sides.mirror_row(c, guess_[c].data(), j, k);
  const double* guess = guess_[c].data() + p;
  double* __restrict__ x = water_.u[c].data() + p;
  const float* open = water_.openings.open[c] + p;
  const auto ask = momentum(c, j, k, guess);
#pragma omp simd
  for (int i = range.begin; i < range.end; ++i) x[i] = guess[i] + step * open[i] * ask(i);
  relax_held(c, j, k, guess, 1 / step, everywhere, x);
}

/// One colour of a Gauss-Seidel sweep on a row; closed faces keep u_o.
template <int D>
void Prediction<D>::relax_row(int c, int j, int k, int colour, double omega) {
  omega *= row_share(j, k);
  const auto& block = water_.grid.block();
  const auto range = multigrid_.live(j, k);
  const int begin = range.begin, end = range.end;
  const long p = block.row(j, k);
  double* x = water_.u[c].data() + p;
  const float* open = water_.openings.open[c] + p;
  const double* on = colour_[(block.parity(j, k) + colour) & 1].data();
  const auto ask = momentum(c, j, k, x);
  const double weight = omega / diagonal_;
  double* __restrict__ fresh = row_buffer_.data();
#pragma omp simd
  for (int i = begin; i < end; ++i) fresh[i] = x[i] + on[i] * weight * open[i] * ask(i);
  relax_held(
      c, j, k, x, diagonal_, [&](int i) { return on[i] * omega; }, fresh);
#pragma omp simd
  for (int i = begin; i < end; ++i) x[i] = fresh[i];
}

/// Ghosts of the guess that neither a neighbour nor a reflection sets: those of u.
template <int D>
void Prediction<D>::take_outer_ghosts() {
  const auto& block = water_.grid.block();
  const auto take = [&](int j, int k) {
    const long p = block.row(j, k);
    for (int c = 0; c < D; ++c)
      std::copy_n(water_.u[c].data() + p - 1, block.width() + 2, guess_[c].data() + p - 1);
  };
  for (int k = -1; k <= block.planes(); ++k) {
    const bool whole = k < 0 || k == block.planes();
    if constexpr (D == 2) {
      if (whole) take(0, k);
    } else {
      for (int j = -1; j <= block.rows(); ++j)
        if (whole || j < 0 || j == block.rows()) take(j, k);
    }
  }
}

template <int D>
void Prediction<D>::advance(double dt, double before, bool held) {
  const auto& grid = water_.grid;
  double diffusion_number = 0;
  for (int d = 0; d < D; ++d) {
    diffusion_[d] =
        water_.viscosity / water_.density * dt / (2 * grid.mesh().h[d] * grid.mesh().h[d]);
    diffusion_number += 2 * diffusion_[d];
  }
  if (odd_[0])
    colour_[0].front() = colour_[0][static_cast<std::size_t>(grid.block().width()) - 1] =
        clash_share(0);
  wall_diffusion_ = water_.viscosity / water_.density * dt;
  const double ratio = before > 0 ? std::min(dt / before, most_growth) : 0;
  const double push = held ? dt / water_.density : 0;
  diagonal_ = 1 + diffusion_number;
  Relaxation relax = relaxation(diffusion_number);
  const Weights weights{dt * (1 + 0.5 * ratio), -0.5 * dt * ratio, push, relax.step};
  if (std::find(odd_.begin(), odd_.end(), true) != odd_.end()) relax.sweeps *= odd_sweeps;
  take_outer_ghosts();
  const int last = relax.sweeps > 0 ? 2 * relax.sweeps + 2 : 1;
  const auto stage = [&](int s, int k, int j0, int j1) {
    for (int j = j0; j < j1; ++j) {
      if (s == 0) {
        start_rows(j, k, weights);
        for (auto& g : guess_) grid.halo().wrap_row(g.data() + grid.block().row(j, k));
        continue;
      }
      for (int c = 0; c < D; ++c)
        if (s == 1)
          leave_guess(c, j, k, relax.step);
        else if (s <= 2 * relax.sweeps + 1)
          relax_row(c, j, k, s & 1, relax.omega);
      if (s == last) {
        water_.to_passage(j, k);
        if (held) take_push_back(j, k, push);
      }
      for (int c = 0; c < D; ++c) {
        water_.sides.mirror_row(c, water_.u[c].data(), j, k);
        grid.halo().wrap_row(water_.u[c].data() + grid.block().row(j, k));
      }
    }
  };
  const auto exchange = [&](int s) { grid.halo().exchange(s == 0 ? guess_ : water_.u); };
  wavefront(grid.block(), grid.halo(), last + 1, stage, exchange, [](int) {});
}

template <int D>
void Prediction<D>::restart() {
  for (auto& c : convection_) c.fill(0);
}

template class Prediction<2>;
template class Prediction<3>;

}  // namespace washtub
