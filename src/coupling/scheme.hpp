#pragma once

namespace washtub {

/// How cloth and water are coupled in time.
enum class Scheme {
  implicit,        ///< one implicit cloth solve a step, stable at the flow's time step
  explicit_euler,  ///< the paper's in 3-D: force at X^n, then dX/dt = U by forward Euler
  broyden,         ///< the paper's in 2-D: X^n+1 = X^n + dt U iterated with the water's response
};

}  // namespace washtub
