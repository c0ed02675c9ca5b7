#include "flow/pressure/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>

#include "base/tally.hpp"
#include "flow/pressure/components.hpp"

namespace washtub {

void set_residual(SolveReport& report, const Parallel& parallel, const ResidualSize& size,
                  double cells) {
  Tally tally{{size.squares, cells}, {size.largest}};
  combine(parallel, tally);
  report.residual = tally.max[0];
  report.rms = tally.sum[1] > 0 ? std::sqrt(tally.sum[0] / tally.sum[1]) : 0;
}

template <int D>
ConjugateGradients<D>::ConjugateGradients(const Grid<D>& grid, Problem<D>& problem)
    : grid_(grid), problem_(problem) {}

template <int D>
template <class Visit>
void ConjugateGradients<D>::for_rows(Visit&& visit) const {
  for (int k = 0; k < problem_.level.block.planes(); ++k)
    for (int j = 0; j < problem_.level.block.rows(); ++j) visit(row_of(problem_, j, k));
}

/// out = A in.
template <int D>
void ConjugateGradients<D>::apply(const double* in, double* out) {
  problem_.x.swap(aside_);
  std::copy_n(in, problem_.x.size(), problem_.x.data());
  problem_.level.halo.exchange(problem_.x.data());
  for_rows([&](const LevelRow<D, double>& row) {
    for (int i = row.begin; i < row.end; ++i) out[row.p + i] = row.b[i] - row.residual(i);
  });
  problem_.x.swap(aside_);
}

template <int D>
double ConjugateGradients<D>::dot(const double* a, const double* b) const {
  double sum = 0;
  for_rows([&](const LevelRow<D, double>& row) {
    for (int i = row.begin; i < row.end; ++i) sum += a[row.p + i] * b[row.p + i];
  });
  return grid_.parallel().sum(sum);
}

template <int D>
ResidualSize ConjugateGradients<D>::residual_size() const {
  ResidualSize size;
  for_rows([&](const LevelRow<D, double>& row) {
    for (int i = row.begin; i < row.end; ++i) size.add({std::abs(row.b[i]), row.b[i] * row.b[i]});
  });
  return size;
}

/// One step along the preconditioned residual problem.x, made conjugate to the step before, whose
/// curvature is given; false if there is nowhere to go.
template <int D>
bool ConjugateGradients<D>::improve(double& curvature) {
  const auto n = static_cast<long>(problem_.x.size());
  const double* z = problem_.x.data();
  double* r = problem_.b.data();
  const double beta = curvature > 0 ? -dot(z, image_.data()) / curvature : 0;
  for (long i = 0; i < n; ++i) direction_[i] = z[i] + beta * direction_[i];
  apply(direction_.data(), image_.data());
  curvature = dot(direction_.data(), image_.data());
  if (!(curvature > 0)) return false;
  const double step = dot(direction_.data(), r) / curvature;
  for (long i = 0; i < n; ++i) {
    solution_[i] += step * direction_[i];
    r[i] -= step * image_[i];
  }
  return true;
}

template <int D>
SolveReport ConjugateGradients<D>::solve(const std::function<void()>& cycle,
                                         const Tolerance& tolerance, SolveReport report,
                                         int max_cycles, double cells) {
  const auto n = problem_.x.size();
  for (auto* a : {&solution_, &direction_, &image_, &aside_})
    if (a->size() == 0) *a = Storage<double>(n);
  remove_component_means(grid_, problem_);
  std::copy_n(problem_.x.data(), n, solution_.data());
  apply(solution_.data(), image_.data());
  double* r = problem_.b.data();  // from here on the right-hand side of the cycle is the residual
  for (long i = 0; i < static_cast<long>(n); ++i) r[i] -= image_[i];
  double curvature = 0;
  const auto& parallel = grid_.parallel();
  set_residual(report, parallel, residual_size(), cells);
  while (!tolerance.met(report) && report.cycles < max_cycles) {
    cycle();
    if (!improve(curvature)) break;
    ++report.cycles;
    set_residual(report, parallel, residual_size(), cells);
  }
  std::copy_n(solution_.data(), n, problem_.x.data());
  problem_.level.halo.exchange(problem_.x.data());
  report.converged = tolerance.met(report);
  return report;
}

template class ConjugateGradients<2>;
template class ConjugateGradients<3>;

}  // namespace washtub
