#pragma once
#include <array>
#include <functional>

#include "flow/pressure/level.hpp"

namespace washtub {

struct SolveReport {
  int cycles = 0;
  /// Largest |b - A p| over the live cells; of a pocket without way out, less its mean, which no
  /// pressure can balance.
  double residual = 0;
  bool converged = false;
};

/// Flexible conjugate gradients for the finest level of a multigrid, with its cycle as
/// preconditioner. Takes memory for its four fields when first needed.
template <int D>
class ConjugateGradients {
 public:
  ConjugateGradients(const Grid<D>& grid, Level<D, double>& level);

  /// Improves level.x until the residual is at most `tolerance` in every live cell; level.b is
  /// lost. The source of every closed pocket of fluid is made compatible first (its mean taken
  /// out), since no pressure can balance it. On return the ghosts of x are current.
  /// @param cycle   x = approximately A^-1 b
  /// @param report  of the cycles so far, which count
  SolveReport solve(const std::function<void()>& cycle, double tolerance, SolveReport report,
                    int max_cycles);

 private:
  template <class Visit>
  void for_rows(Visit&& visit) const;
  void apply(const double* in, double* out);
  double dot(const double* a, const double* b) const;
  double largest_residual() const;
  bool improve(double& curvature);

  const Grid<D>& grid_;
  Level<D, double>& level_;
  Storage<double> solution_, direction_, image_, aside_;
};

}  // namespace washtub
