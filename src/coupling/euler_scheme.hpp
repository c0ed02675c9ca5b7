#pragma once
#include "coupling/coupling_scheme.hpp"

namespace washtub {

/// The paper's scheme in 3-D: the force of X^n, then X^n+1 = X^n + dt U.
template <int D>
class EulerScheme : public CouplingScheme<D> {
 public:
  explicit EulerScheme(CoupledStep<D>& step) : step_(step) {}

  double ahead() const override { return 0; }
  void push() override;
  void move() override;

 private:
  CoupledStep<D>& step_;
};

}  // namespace washtub
