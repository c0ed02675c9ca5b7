#include "cloth/implicit.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

namespace washtub {
namespace {

template <int D>
int springs_per_node(const Sheet<D>& sheet) {
  std::vector<int> count(sheet.nodes(), 0);
  const auto add = [&](const auto& strains) {
    for (const auto& e : strains)
      for (const auto& leg : e.leg) ++count[leg[0]], ++count[leg[1]];
  };
  const auto add_all = [&](const auto& elements) {
    add(elements.edges);
    add(elements.shears);
    add(elements.dilations);
  };
  add_all(sheet.inner);
  add_all(sheet.seam);
  return *std::max_element(count.begin(), count.end());
}

template <int D>
std::size_t membrane_strains(const Sheet<D>& sheet) {
  const auto count = [](const auto& e) {
    return e.edges.size() + e.shears.size() + e.dilations.size();
  };
  return count(sheet.inner) + count(sheet.seam);
}

/// Least eigenvalue of a symmetric matrix.
template <int D>
double least_stiffness(const Mat<D>& K) {
  if (K.isDiagonal(0)) return K.diagonal().minCoeff();
  return Eigen::SelfAdjointEigenSolver<Mat<D>>()
      .computeDirect(K, Eigen::EigenvaluesOnly)
      .eigenvalues()[0];
}

}  // namespace

template <int D>
ClothSolver<D>::ClothSolver(Sheet<D> sheet, const std::vector<int>& pinned, double tolerance)
    : sheet_(std::move(sheet)),
      tolerance_(tolerance * sheet_.smallest_spacing()),
      springs_(springs_per_node(sheet_)),
      cholesky_(sheet_.nodes(), couplings(sheet_), pinned),
      assembly_(sheet_, cholesky_.blocks(), [&](int x, int y) { return cholesky_.place(x, y); }) {
  const auto size = static_cast<std::size_t>(sheet_.nodes()) * D * lanes;
  for (Field* field : {&X_, &Z_, &step_, &trial_, &ordered_}) field->assign(size, 0.0);
  K_.assign(size * D, 0.0);
  if (sheet_.material.loss_time > 0) past_.assign(membrane_strains(sheet_) * lanes, 0.0);
}

template <int D>
auto ClothSolver<D>::solve(std::span<const int> pieces, const ClothProblem<D>& problem,
                           std::span<Vec<D>> Y, std::span<Vec<D>> F) -> Report {
  Report out;
  for (std::size_t first = 0; first < pieces.size(); first += lanes) {
    const auto batch = pieces.subspan(first, std::min<std::size_t>(lanes, pieces.size() - first));
    load(batch, problem);
    out.factorisations += find_minimum();
    store(batch, X_, Y);
    std::fill(trial_.begin(), trial_.end(), 0.0);
    elastic::add_force<D, lanes>(sheet_, X_.data(), trial_.data(), loss_);
    store(batch, trial_, F);
    report(batch, out);
  }
  return out;
}

/// Lanes beyond the last piece repeat it.
template <int D>
int ClothSolver<D>::piece(std::span<const int> pieces, int lane) const {
  return pieces[std::min<std::size_t>(lane, pieces.size() - 1)];
}

template <int D>
void ClothSolver<D>::load(std::span<const int> pieces, const ClothProblem<D>& problem) {
  const int nodes = sheet_.nodes();
  for (int l = 0; l < lanes; ++l) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(piece(pieces, l)) * nodes;
    double softest = std::numeric_limits<double>::infinity();
    for (int x = 0; x < nodes; ++x) {
      const Mat<D>& K = problem.stiffness[offset + x];
      softest = std::min(softest, least_stiffness<D>(K));
      for (int c = 0; c < D * D; ++c) K_[(x * D * D + c) * lanes + l] = K(c / D, c % D);
    }
    // By Gershgorin's theorem springs down to -k/(2 springs) leave K + Hessian definite.
    safe_floor_[l] = -0.4 * softest / springs_;
  }
  find_loss(pieces, problem);
  load(pieces, problem.target, Z_);
  X_ = Z_;
}

template <int D>
void ClothSolver<D>::load(std::span<const int> pieces, std::span<const Vec<D>> from,
                          Field& to) const {
  const int nodes = sheet_.nodes();
  for (int l = 0; l < lanes; ++l) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(piece(pieces, l)) * nodes;
    for (int x = 0; x < nodes; ++x)
      for (int c = 0; c < D; ++c) to[(x * D + c) * lanes + l] = from[offset + x][c];
  }
}

template <int D>
void ClothSolver<D>::find_loss(std::span<const int> pieces, const ClothProblem<D>& problem) {
  loss_ = {};
  const double tau = sheet_.material.loss_time;
  if (!(tau > 0 && problem.dt > 0)) return;
  load(pieces, problem.before, trial_);
  elastic::find_past<D, lanes>(sheet_, trial_.data(), tau / (tau + problem.dt), past_.data());
  loss_ = {1 + tau / problem.dt, past_.data()};
}

template <int D>
void ClothSolver<D>::store(std::span<const int> pieces, const Field& from,
                           std::span<Vec<D>> to) const {
  for (std::size_t l = 0; l < pieces.size(); ++l) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(pieces[l]) * sheet_.nodes();
    for (int x = 0; x < sheet_.nodes(); ++x)
      for (int c = 0; c < D; ++c) to[offset + x][c] = from[(x * D + c) * lanes + l];
  }
}

template <int D>
void ClothSolver<D>::report(std::span<const int> pieces, Report& out) const {
  PerLane strain;
  elastic::largest_strain<D, lanes>(sheet_, X_.data(), strain.data());
  for (std::size_t l = 0; l < pieces.size(); ++l) {
    out.iterations = std::max(out.iterations, steps_[l]);
    out.largest_strain = std::max(out.largest_strain, strain[l]);
    if (failed_[l] && out.failed < 0) out.failed = pieces[l];
  }
}

/// On return each lane is converged or failed. Returns the number of factorisations.
template <int D>
int ClothSolver<D>::find_minimum() {
  active_.fill(true);
  failed_.fill(false);
  steps_.fill(0);
  objective_ = objective(X_);
  factorise(safe_floor_);
  find_step();
  int factorisations = 1;
  while (true) {
    const PerLane previous = size_;
    advance();
    if (!retire()) return factorisations;
    find_step();
    if (!shrinks(previous)) factorisations += refactorise();
  }
}

/// On return the step is that of a factor of the full Hessian at X, and in lanes where that is not
/// positive definite, of the safe one. Returns the number of factorisations.
template <int D>
int ClothSolver<D>::refactorise() {
  PerLane floor;
  floor.fill(-std::numeric_limits<double>::infinity());
  factorise(floor);
  find_step();
  bool definite = true;
  for (int l = 0; l < lanes; ++l) {
    if (std::isfinite(size_[l])) continue;
    floor[l] = safe_floor_[l];
    definite = false;
  }
  if (definite) return 1;
  factorise(floor);
  find_step();
  return 2;
}

/// sum (X - Z).K (X - Z)/2 + W(X) of each lane [J].
template <int D>
auto ClothSolver<D>::objective(const Field& X) const -> PerLane {
  PerLane sum{};
  elastic::add_energy<D, lanes>(sheet_, X.data(), sum.data(), loss_);
  for (int x = 0; x < sheet_.nodes(); ++x) {
    const double* K = K_.data() + static_cast<std::ptrdiff_t>(x) * D * D * lanes;
    const double *at = X.data() + x * D * lanes, *to = Z_.data() + x * D * lanes;
    for (int c = 0; c < D * D; ++c) {
      const int r = c / D * lanes, s = c % D * lanes;
#pragma omp simd
      for (int l = 0; l < lanes; ++l)
        sum[l] += 0.5 * K[c * lanes + l] * (at[r + l] - to[r + l]) * (at[s + l] - to[s + l]);
    }
  }
  return sum;
}

/// pull = -K (X - Z).
template <int D>
void ClothSolver<D>::find_pull(const Field& X, Field& pull) const {
  std::fill(pull.begin(), pull.end(), 0.0);
  for (int x = 0; x < sheet_.nodes(); ++x) {
    const double* K = K_.data() + static_cast<std::ptrdiff_t>(x) * D * D * lanes;
    for (int c = 0; c < D * D; ++c) {
      const int r = (x * D + c / D) * lanes, s = (x * D + c % D) * lanes;
#pragma omp simd
      for (int l = 0; l < lanes; ++l) pull[r + l] -= K[c * lanes + l] * (X[s + l] - Z_[s + l]);
    }
  }
}

template <int D>
void ClothSolver<D>::factorise(const PerLane& floor) {
  assembly_.template assemble<lanes>(X_.data(), floor.data(), cholesky_.data(), loss_);
  for (int x = 0; x < sheet_.nodes(); ++x) {
    const Place p = cholesky_.place(x, x);
    if (p.index < 0) continue;
    double* block = cholesky_.data() + static_cast<std::ptrdiff_t>(p.index) * D * D * lanes;
    for (int i = 0; i < D * D * lanes; ++i) block[i] += K_[x * D * D * lanes + i];
  }
  cholesky_.factorise();
}

/// On return `step_` is minus the last factor's inverse times the gradient at X, zero in lanes that
/// are not active, and `size_` its largest component, or not a number if one is not.
template <int D>
void ClothSolver<D>::find_step() {
  find_pull(X_, step_);
  elastic::add_force<D, lanes>(sheet_, X_.data(), step_.data(), loss_);
  constexpr int stride = D * lanes;
  for (int x = 0; x < sheet_.nodes(); ++x)
    if (const int p = cholesky_.position(x); p >= 0)
      std::copy_n(step_.data() + x * stride, stride, ordered_.data() + p * stride);
  cholesky_.solve(ordered_.data());
  measure_step();
}

template <int D>
void ClothSolver<D>::measure_step() {
  constexpr int stride = D * lanes;
  size_.fill(0);
  for (int x = 0; x < sheet_.nodes(); ++x) {
    const int p = cholesky_.position(x);
    for (int i = 0; i < stride; ++i) {
      const int l = i % lanes;
      const double s = p >= 0 && active_[l] ? ordered_[p * stride + i] : 0.0;
      step_[x * stride + i] = s;
      if (std::fabs(s) > size_[l] || std::isnan(s)) size_[l] = std::fabs(s);
    }
  }
}

/// Whether the factor at hand still serves every lane.
template <int D>
bool ClothSolver<D>::shrinks(const PerLane& previous) const {
  for (int l = 0; l < lanes; ++l)
    if (active_[l] && !(size_[l] <= std::max(reuse * previous[l], tolerance_))) return false;
  return true;
}

/// Fails lanes whose step is not finite, and leaves them where they are.
template <int D>
void ClothSolver<D>::drop_broken() {
  for (int l = 0; l < lanes; ++l) {
    if (std::isfinite(size_[l])) continue;
    failed_[l] = true;
    for (std::size_t i = l; i < step_.size(); i += lanes) step_[i] = 0;
  }
}

/// Moves each lane along its step, halved until its objective does not grow beyond round-off.
template <int D>
void ClothSolver<D>::advance() {
  drop_broken();
  PerLane fraction;
  fraction.fill(1);
  while (true) {
    for (std::size_t i = 0; i < X_.size(); i += lanes)
      for (int l = 0; l < lanes; ++l) trial_[i + l] = X_[i + l] + fraction[l] * step_[i + l];
    const PerLane now = objective(trial_);
    bool lower = true;
    for (int l = 0; l < lanes; ++l) {
      if (!active_[l] || failed_[l] || size_[l] <= tolerance_) continue;
      if (now[l] <= objective_[l] * (1 + 1e-12)) continue;
      fraction[l] /= 2;
      lower = false;
      if (fraction[l] < shortest) fraction[l] = 0, failed_[l] = true;
    }
    if (!lower) continue;
    X_.swap(trial_);
    objective_ = now;
    return;
  }
}

/// Takes lanes that have converged or failed out of the iteration. Returns whether any is left.
template <int D>
bool ClothSolver<D>::retire() {
  for (int l = 0; l < lanes; ++l) {
    if (!active_[l]) continue;
    ++steps_[l];
    if (steps_[l] == max_steps && size_[l] > enough * sheet_.smallest_spacing()) failed_[l] = true;
    active_[l] = !failed_[l] && size_[l] > tolerance_ && steps_[l] < max_steps;
  }
  return std::any_of(active_.begin(), active_.end(), [](bool a) { return a; });
}

template class ClothSolver<2>;
template class ClothSolver<3>;

}  // namespace washtub
