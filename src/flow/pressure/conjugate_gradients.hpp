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
  double rms = 0;  ///< root of its mean square over the live cells
  bool converged = false;
};

/// When a solve may stop: both hold.
struct Tolerance {
  double residual, rms;  ///< bounds of SolveReport's

  Tolerance(double largest) : Tolerance(largest, largest) {}
  Tolerance(double residual_, double rms_) : residual(residual_), rms(rms_) {}
  bool met(const SolveReport& report) const {
    return report.residual <= residual && report.rms <= rms;
  }
};

/// Takes what is left on this rank, in so many live cells, to the report of all (collective).
void set_residual(SolveReport& report, const Parallel& parallel, const ResidualSize& size,
                  double cells);

/// Flexible conjugate gradients for the problem of a multigrid, with its cycle as
/// preconditioner. Takes memory for its four fields when first needed.
template <int D>
class ConjugateGradients {
 public:
  ConjugateGradients(const Grid<D>& grid, Problem<D>& problem);

  /// Improves the problem's x until the residual is within `tolerance`; its b is lost. The source
  /// of every closed pocket of fluid is made compatible first (its mean taken out), since no
  /// pressure can balance it. On return the ghosts of x are current.
  /// @param cycle   x = approximately A^-1 b
  /// @param report  of the cycles so far, which count
  /// @param cells   live ones of this rank
  SolveReport solve(const std::function<void()>& cycle, const Tolerance& tolerance,
                    SolveReport report, int max_cycles, double cells);

 private:
  template <class Visit>
  void for_rows(Visit&& visit) const;
  void apply(const double* in, double* out);
  double dot(const double* a, const double* b) const;
  ResidualSize residual_size() const;
  bool improve(double& curvature);

  const Grid<D>& grid_;
  Problem<D>& problem_;
  Storage<double> solution_, direction_, image_, aside_;
};

}  // namespace washtub
