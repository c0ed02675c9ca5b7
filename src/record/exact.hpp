#pragma once
#include "case/vector_field.hpp"
#include "record/sample.hpp"
#include "washer/simulation.hpp"

namespace washtub {

/// Compares the velocity with an exact solution, Eq. (A.13): each component u_d on its own faces,
/// those that are open and lie inside the water, without those on sides of the box. Relative errors
/// are over the exact speed |u_ex| at the face, and leave out faces where that is zero.
template <int D>
class ExactSolution {
 public:
  explicit ExactSolution(const ExactCase& exact)
      : field_(exact.velocity, "the velocity"), relative_(exact.relative) {}

  /// Errors of the velocity now: in m/s, or of the exact speed (collective).
  VelocityError compare(const Simulation<D>& simulation) const;

 private:
  /// What the component d on the face at x counts; negative if not at all.
  double error(double u, int d, const Vec<D>& x, double t) const;

  VectorField<D> field_;
  bool relative_;
};

}  // namespace washtub
