#include <algorithm>
#include <cmath>

#include "flow/pressure/components.hpp"
#include "flow/pressure/multigrid.hpp"

namespace washtub {

template <int D>
void Multigrid<D>::apply(const double* in, double* out) {
  finest_.x.swap(krylov_[3]);
  std::copy_n(in, finest_.x.size(), finest_.x.data());
  finest_.halo.exchange(finest_.x.data());
  for (int k = 0; k < finest_.block.planes(); ++k)
    for (int j = 0; j < finest_.block.rows(); ++j) {
      const LevelRow<D, double> row(finest_, j, k);
      for (int i = row.begin; i < row.end; ++i) out[row.p + i] = row.b[i] - row.residual(i);
    }
  finest_.x.swap(krylov_[3]);
}

template <int D>
double Multigrid<D>::dot(const double* a, const double* b) const {
  double sum = 0;
  for (int k = 0; k < finest_.block.planes(); ++k)
    for (int j = 0; j < finest_.block.rows(); ++j) {
      const LevelRow<D, double> row(finest_, j, k);
      for (int i = row.begin; i < row.end; ++i) sum += a[row.p + i] * b[row.p + i];
    }
  return grid_.parallel().sum(sum);
}

/// Flexible conjugate gradients around the cycle. The source of every closed pocket of fluid is
/// made compatible first (its mean taken out), since no pressure can balance it.
template <int D>
SolveReport Multigrid<D>::solve_krylov(double tolerance, SolveReport report, int max_cycles) {
  const auto n = finest_.x.size();
  for (auto& a : krylov_)
    if (a.size() == 0) a = Storage<double>(n);
  auto& solution = krylov_[0];
  auto& direction = krylov_[1];
  auto& image = krylov_[2];
  remove_component_means(grid_, finest_);
  std::copy_n(finest_.x.data(), n, solution.data());
  apply(solution.data(), image.data());
  double* r = finest_.b.data();  // from here on the right-hand side of the cycle is the residual
  for (std::size_t i = 0; i < n; ++i) r[i] -= image[static_cast<long>(i)];
  double curvature = 0;
  const auto largest = [&] {
    double m = 0;
    for (int k = 0; k < finest_.block.planes(); ++k)
      for (int j = 0; j < finest_.block.rows(); ++j) {
        const LevelRow<D, double> row(finest_, j, k);
        for (int i = row.begin; i < row.end; ++i) m = std::max(m, std::abs(r[row.p + i]));
      }
    return grid_.parallel().max(m);
  };
  report.residual = largest();
  while (report.residual > tolerance && report.cycles < max_cycles) {
    cycle_from_zero();
    const double* z = finest_.x.data();
    const double beta = curvature > 0 ? -dot(z, image.data()) / curvature : 0;
    for (std::size_t i = 0; i < n; ++i) {
      const auto q = static_cast<long>(i);
      direction[q] = z[q] + beta * direction[q];
    }
    apply(direction.data(), image.data());
    curvature = dot(direction.data(), image.data());
    if (!(curvature > 0)) break;
    const double step = dot(direction.data(), r) / curvature;
    for (std::size_t i = 0; i < n; ++i) {
      const auto q = static_cast<long>(i);
      solution[q] += step * direction[q];
      r[q] -= step * image[q];
    }
    ++report.cycles;
    report.residual = largest();
  }
  std::copy_n(solution.data(), n, finest_.x.data());
  finest_.halo.exchange(finest_.x.data());
  report.converged = report.residual <= tolerance;
  return report;
}

template class Multigrid<2>;
template class Multigrid<3>;

}  // namespace washtub
