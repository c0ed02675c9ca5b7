#pragma once
#include <vector>

#include "base/vec.hpp"

namespace washtub {

/// Broyden's "good" method for R(X) = 0, from the identity as the first guess of dR/dX and without
/// a line search. It keeps the steps it took and no matrix: the inverse Jacobian is a product of
/// one rank-one factor per step (Kelley, Iterative Methods for Linear and Nonlinear Equations,
/// 1995, section 7.3).
template <int D>
class Broyden {
 public:
  using Nodes = std::vector<Vec<D>>;

  /// Forgets the steps of the equation before.
  void start() { count_ = 0; }
  /// Steps taken since then.
  int count() const { return count_; }
  /// What to add to the X at which the residual is R. Allocates only where more steps are taken
  /// than ever before.
  const Nodes& step(const Nodes& R);

 private:
  std::vector<Nodes> steps_;  ///< the first count_ of them are of this equation
  int count_ = 0;
};

}  // namespace washtub
