#pragma once
#include "coupling/broyden.hpp"
#include "coupling/coupling_scheme.hpp"

namespace washtub {

/// The paper's scheme for 2-D: X = X^n + dt U, Eq. (6), with U the velocity of the projected water
/// under the force of X itself, so that each iteration costs a projection. Force and inertia are
/// taken at X^n+1, the delta functions stay at X^n + dt V^n / 2: with spreading and interpolation
/// at the same places backward Euler loses energy for any step (Newren et al., J. Comput. Phys.
/// 222, 2007); a trapezoidal force would leave the stiffest waves undamped, and delta functions at
/// X^n+1 would make the equation rougher for the same order in time. The iteration, not stability,
/// limits the step.
template <int D>
class BroydenScheme : public CouplingScheme<D> {
 public:
  explicit BroydenScheme(CoupledStep<D>& step);

  void push() override;
  /// @throws RunError when the iteration does not converge
  bool again() override;
  void move() override { step_.measure_strain(); }

 private:
  double find_residual();
  void find_force();

  CoupledStep<D>& step_;
  Broyden<D> broyden_;
  typename Broyden<D>::Nodes residual_;  ///< X - X^n - dt U [m]
  std::vector<double> spacing_;          ///< smallest node spacing of each node's piece [m]
};

}  // namespace washtub
