#pragma once

namespace washtub {

/// How cloth and water are coupled in time.
enum class Scheme {
  implicit,        ///< one implicit cloth solve a step, stable at the flow's time step
  explicit_euler,  ///< the paper's: force at X^n, then dX/dt = U by forward Euler
};

}  // namespace washtub
