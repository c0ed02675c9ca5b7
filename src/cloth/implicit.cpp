#include "cloth/implicit.hpp"

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

}  // namespace

template <int D>
ClothSolver<D>::ClothSolver(Sheet<D> sheet, const std::vector<int>& pinned, double tolerance)
    : sheet_(std::move(sheet)),
      tolerance_(tolerance * sheet_.smallest_spacing()),
      springs_(springs_per_node(sheet_)),
      cholesky_(sheet_.nodes(), couplings(sheet_), pinned),
      assembly_(sheet_, cholesky_.blocks(), [&](int x, int y) { return cholesky_.place(x, y); }) {
  const auto size = static_cast<std::size_t>(sheet_.nodes()) * D * lanes;
  for (Field* field : {&X_, &Z_, &k_, &step_, &trial_, &ordered_}) field->assign(size, 0.0);
}

template <int D>
auto ClothSolver<D>::solve(std::span<const int> pieces, std::span<const Vec<D>> stiffness,
                           std::span<const Vec<D>> target, std::span<Vec<D>> Y) -> Report {
  Report out;
  for (std::size_t first = 0; first < pieces.size(); first += lanes) {
    const auto batch = pieces.subspan(first, std::min<std::size_t>(lanes, pieces.size() - first));
    load(batch, stiffness, target);
    out.factorisations += find_minimum();
    store(batch, Y);
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
void ClothSolver<D>::load(std::span<const int> pieces, std::span<const Vec<D>> stiffness,
                          std::span<const Vec<D>> target) {
  const int nodes = sheet_.nodes();
  for (int l = 0; l < lanes; ++l) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(piece(pieces, l)) * nodes;
    double smallest = std::numeric_limits<double>::infinity();
    for (int x = 0; x < nodes; ++x) {
      const Vec<D>&k = stiffness[offset + x], &z = target[offset + x];
      smallest = std::min(smallest, k.minCoeff());
      for (int c = 0; c < D; ++c) {
        const int i = (x * D + c) * lanes + l;
        k_[i] = k[c];
        Z_[i] = z[c];
      }
    }
    // By Gershgorin's theorem springs down to -k/(2 springs) leave k + Hessian definite.
    safe_floor_[l] = -0.4 * smallest / springs_;
  }
  X_ = Z_;
}

template <int D>
void ClothSolver<D>::store(std::span<const int> pieces, std::span<Vec<D>> Y) const {
  for (std::size_t l = 0; l < pieces.size(); ++l) {
    const std::ptrdiff_t offset = static_cast<std::ptrdiff_t>(pieces[l]) * sheet_.nodes();
    for (int x = 0; x < sheet_.nodes(); ++x)
      for (int c = 0; c < D; ++c) Y[offset + x][c] = X_[(x * D + c) * lanes + l];
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

/// sum k (X - Z)^2/2 + W(X) of each lane [J].
template <int D>
auto ClothSolver<D>::objective(const Field& X) const -> PerLane {
  PerLane sum{};
  elastic::add_energy<D, lanes>(sheet_, X.data(), sum.data());
  for (std::size_t i = 0; i < X.size(); i += lanes) {
#pragma omp simd
    for (int l = 0; l < lanes; ++l) {
      const double d = X[i + l] - Z_[i + l];
      sum[l] += 0.5 * k_[i + l] * d * d;
    }
  }
  return sum;
}

template <int D>
void ClothSolver<D>::factorise(const PerLane& floor) {
  assembly_.template assemble<lanes>(X_.data(), floor.data(), cholesky_.data());
  for (int x = 0; x < sheet_.nodes(); ++x) {
    const Place p = cholesky_.place(x, x);
    if (p.index < 0) continue;
    double* block = cholesky_.data() + static_cast<std::ptrdiff_t>(p.index) * D * D * lanes;
    for (int c = 0; c < D; ++c)
      for (int l = 0; l < lanes; ++l) block[c * (D + 1) * lanes + l] += k_[(x * D + c) * lanes + l];
  }
  cholesky_.factorise();
}

/// On return `step_` is minus the last factor's inverse times the gradient at X, zero in lanes that
/// are not active, and `size_` its largest component, or not a number if one is not.
template <int D>
void ClothSolver<D>::find_step() {
  for (std::size_t i = 0; i < X_.size(); ++i) step_[i] = -k_[i] * (X_[i] - Z_[i]);
  elastic::add_force<D, lanes>(sheet_, X_.data(), step_.data());
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
