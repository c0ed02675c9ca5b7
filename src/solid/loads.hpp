#pragma once
#include "solid/mapping.hpp"

namespace washtub {

/// Force and moment about the vertical through the solid's centre (per metre in 2-D).
template <int D>
struct Load {
  Vec<D> force = Vec<D>::Zero();  ///< [N]
  double torque = 0;              ///< [N m]

  /// A force along `axis` at x: the moment of F along x is -y F, of F along y it is x F.
  void add(const Vec<D>& x, const Vec<3>& centre, int axis, double along) {
    force[axis] += along;
    if (axis == 0) torque -= (x[1] - centre[1]) * along;
    if (axis == 1) torque += (x[0] - centre[0]) * along;
  }

  Load& operator+=(const Load& other) {
    force += other.force;
    torque += other.torque;
    return *this;
  }
};

/// The state of the water that loads on solids come from.
template <int D>
struct WaterState {
  std::array<const double*, D> velocity;  ///< [m/s]
  const double* pressure;                 ///< [Pa]
  std::array<const double*, D> force;     ///< force density of the cloth [N/m^3]
  double density, viscosity;
};

/// What the water does to a solid, by parts.
template <int D>
struct SurfaceLoads {
  Load<D> friction;    ///< viscous stress on the staircase surface
  Load<D> pressure;    ///< pressure on the closed faces
  Load<D> convection;  ///< momentum carried into and out of the staircase
  Load<D> cloth;       ///< cloth force that reaches into the solid

  Load<D> total() const {
    return {friction.force + pressure.force + convection.force + cloth.force,
            friction.torque + pressure.torque + convection.torque + cloth.torque};
  }
  SurfaceLoads& operator+=(const SurfaceLoads& other) {
    friction += other.friction;
    pressure += other.pressure;
    convection += other.convection;
    cloth += other.cloth;
    return *this;
  }
};

/// Loads on one solid from the momentum that passes between open and closed faces: viscous stress
/// mu (grad u + grad u^T) and convective flux rho u u on the edges where the open fraction leaves
/// 1, and the pressure of the cells on both sides of each face that is not fully open (zero inside
/// solids). What a solid receives the water loses, see also SurfaceWater; the transposed
/// gradient does not appear in the water's own equation, where its divergence vanishes, but a
/// turning surface feels it. Sum over this rank only.
template <int D>
SurfaceLoads<D> surface_loads(const Grid<D>& grid, const DomainMapping<D>& mapping,
                              std::size_t solid, const WaterState<D>& water);

/// The torque of these loads alone: what acts along the vertical has none.
template <int D>
double surface_torque(const Grid<D>& grid, const DomainMapping<D>& mapping, std::size_t solid,
                      const WaterState<D>& water);

}  // namespace washtub
