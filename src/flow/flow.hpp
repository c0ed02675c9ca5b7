#pragma once
#include <array>
#include <functional>

#include "flow/passing_water.hpp"
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

  /// @throws InputError when water enters through a side and none lets it out.
  Flow(const Grid<D>& grid, double density, double viscosity, const SidePairs<D>& sides,
       const Openings<D>& openings);

  /// Initial state: u_d(x) = field(x)[d] on open faces, on outflow and far-field sides and in all
  /// ghosts; closed faces keep the velocity of their solid, inflow sides take their own in the
  /// first step. To be called before that step. `field`: position [m] -> velocity [m/s].
  void set_velocity(const std::function<Vec<D>(const Vec<D>&)>& field);

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
  /// and u* = u_o on closed faces. The step may change from call to call. Once no face has flipped
  /// for two steps, unless a force acts, the viscous solve holds the last pressure gradient, so
  /// that walls keep their velocity with it; on return it is taken out again.
  void predict(double dt);

  /// Keeps u*, to be called between predict() and project().
  void keep_prediction();
  /// Brings back the u* that was kept, so that project() can follow again with another force(). It
  /// then starts from the last pressure.
  void return_to_prediction();

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

  /// Forgets pressure, force and the steps so far; the velocity stays.
  void restart();
  /// What goes on from step to step. After reading, the openings are taken up as they are now.
  void state(Archive& archive);

  /// Ghosts of the velocity from other ranks and from the sides (after setting an initial state).
  void refresh_ghosts();

 private:
  /// Weights of the right-hand side of the viscous solve.
  struct Weights {
    double now, before;  ///< of the convection of this step and the one before [s]
    double push;         ///< dt/rho of the last pressure gradient, or 0 [m^3 s/kg]
  };
  /// First guess of the pressure: a p + b p_before; `keep_before`: leave p_before as it is.
  struct Guess {
    double last, before;
    bool keep_before;
  };
  std::array<double*, D> velocities();
  template <int c, bool pushed>
  void predict_row(int j, int k, const Weights& weights);
  void predict_rows(int j, int k, const Weights& weights);
  void take_push_back(int j, int k, double push);
  void relax_row(int c, int j, int k, int colour, double omega);
  void exchange_velocity();
  double add_force_row(int j, int k, double dt);
  Guess first_guess() const;
  void start_pressure_row(int j, int k, double dt, const Guess& guess);
  void correct_row(int j, int k, double dt, Report& report);

  const Grid<D>& grid_;
  double density_, viscosity_;
  SidePairs<D> conditions_;
  Sides<D> sides_;
  PassingWater<D> passing_;
  Openings<D> openings_;
  Multigrid<D> multigrid_;
  Components u_, f_, rhs_, convection_, target_;
  Components prediction_;  ///< allocated by the first keep_prediction()
  Field pressure_before_;
  std::array<double, D> diffusion_{};  ///< nu dt / (2 h^2)
  double last_step_ = 0;
  double speed_ = 0;
  int steps_since_flip_ = -1;  ///< the start counts as a flip: its pressure holds an impulse
  bool forced_ = false;        ///< the last force was not zero everywhere
  bool projected_ = false;     ///< this step's u* has had a projection already
  std::vector<double> row_buffer_;
  std::array<std::vector<double>, 2> colour_;
};

}  // namespace washtub
