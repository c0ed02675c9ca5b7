#pragma once
#include "flow/fields.hpp"

namespace washtub {

/// What the velocity would become if neither force nor pressure of the step before changed,
/// u* + dt/rho (f - grad p), at single faces of this rank.
template <int D>
class ProvisionalVelocity {
 public:
  ProvisionalVelocity(const FlowFields<D>& water, const Field& pressure, double dt)
      : water_(water), pressure_(pressure), per_density_(dt / water.density) {}

  /// Component c [m/s], to be called with the memory position of a face.
  auto component(int c) const {
    return [u = water_.u[c].data(), f = water_.f[c].data(), open = water_.openings.open[c],
            p = pressure_.data(), s = c == 0 ? 1L : water_.grid.block().stride[c], a = per_density_,
            per_h = 1 / water_.grid.mesh().h[c]](long i) {
      return u[i] + a * open[i] * (f[i] - per_h * (p[i] - p[i - s]));
    };
  }

 private:
  const FlowFields<D>& water_;
  const Field& pressure_;
  double per_density_;
};

}  // namespace washtub
