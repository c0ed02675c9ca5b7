#pragma once
#include <array>

#include "flow/pressure/multigrid.hpp"
#include "flow/sides.hpp"
#include "grid/grid.hpp"

namespace washtub {

/// How solids stand in the grid, as the flow needs to know it.
template <int D>
struct Openings {
  std::array<const float*, D> open;  ///< open fraction of each face, ghosts included
  bool smooth = false;               ///< open fractions between 0 and 1 occur
};

/// Incompressible Navier-Stokes on the MAC grid, Eqs. (1)-(2): Adams-Bashforth 3/2 convection in
/// divergence form, Crank-Nicolson viscosity, projection. One step is
///   predict(dt)  ->  (spread a force into force())  ->  project(dt).
template <int D>
class Flow {
 public:
  using Components = std::array<Field, D>;

  Flow(const Grid<D>& grid, double density, double viscosity,
       const std::array<std::array<Side<D>, 2>, D>& sides, const Openings<D>& openings);

  Components& velocity() { return u_; }
  const Components& velocity() const { return u_; }
  /// Force density of the cloth on the water [N/m^3], kept from step to step.
  Components& force() { return f_; }
  const Components& force() const { return f_; }
  /// Solid velocity on partly open faces; present with smooth openings only [m/s].
  Components& target() { return target_; }
  const Field& pressure() const { return multigrid_.pressure(); }  ///< [Pa]
  const Openings<D>& openings() const { return openings_; }
  const Multigrid<D>& multigrid() const { return multigrid_; }
  double density() const { return density_; }
  double viscosity() const { return viscosity_; }
  const Grid<D>& grid() const { return grid_; }

  /// Open fractions changed in the planes [k0, k1) of this rank; `flipped` if some did at once.
  void openings_changed(int k0, int k1, bool flipped);

  /// On return velocity() holds u* = u + dt (convection + viscosity), without pressure and force,
  /// and u* = u_o on closed faces. The step may change from call to call.
  void predict(double dt);

  /// Writes u* + dt/rho (f - grad p) with the force and pressure of the step before into `out`:
  /// what the velocity would become if neither changed. Faces of this rank only.
  void provisional(double dt, Components& out) const;

  struct Report {
    SolveReport pressure;
    double divergence = 0;  ///< bound of |div u| h / U after the projection
    double speed = 0;       ///< largest |u| component on faces [m/s]
    double courant = 0;     ///< largest sum over axes of |u_d| / h_d [1/s]
    double kinetic = 0;     ///< kinetic energy of the water [J] (per metre in 2-D)
  };
  /// On return |div u| h <= tolerance U in every fluid cell and velocity() is u at the new time,
  /// ghosts current. The pressure includes the reaction to force().
  Report project(double dt, double tolerance, int max_cycles);

  /// Ghosts of the velocity from other ranks and from the sides (after setting an initial state).
  void refresh_ghosts();

 private:
  template <int c>
  void predict_row(int j, int k, double now, double before);
  void relax_row(int c, int j, int k, int colour, double omega);
  void exchange_velocity();
  double add_force_row(int j, int k, double dt);
  void start_pressure_row(int j, int k, double dt);
  void correct_row(int j, int k, double dt, Report& report);

  const Grid<D>& grid_;
  double density_, viscosity_;
  Sides<D> sides_;
  Openings<D> openings_;
  Multigrid<D> multigrid_;
  Components u_, f_, rhs_, convection_, target_;
  Field pressure_before_;
  std::array<double, D> diffusion_{};  ///< nu dt / (2 h^2)
  double last_step_ = 0;
  double speed_ = 0;
  int steps_since_flip_ = 0;
  std::vector<double> row_buffer_;
  std::array<std::vector<double>, 2> colour_;
};

}  // namespace washtub
