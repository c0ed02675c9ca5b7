#pragma once
#include "flow/fields.hpp"
#include "flow/prediction.hpp"
#include "flow/projection.hpp"
#include "flow/provisional.hpp"

namespace washtub {

/// Incompressible Navier-Stokes on the MAC grid, Eqs. (1)-(2). One step is
///   predict(dt)  ->  (spread a force into force())  ->  project().
/// Calls in any other order throw std::logic_error.
template <int D>
class Flow {
 public:
  using Report = typename Projection<D>::Report;

  /// @throws InputError when water enters through a side and none lets it out.
  Flow(const Grid<D>& grid, double density, double viscosity, const SidePairs<D>& sides,
       const Openings<D>& openings);

  /// Initial state: u_d(x) = field(x)[d] on open faces, on outflow and far-field sides and in all
  /// ghosts; closed faces keep the velocity of their solid, inflow sides take their own in the
  /// first step. To be called before that step. `field`: position [m] -> velocity [m/s].
  void set_velocity(const std::function<Vec<D>(const Vec<D>&)>& field);

  Components<D>& velocity() { return water_.u; }
  const Components<D>& velocity() const { return water_.u; }
  /// Force density of the cloth on the water [N/m^3], kept from step to step.
  Components<D>& force() { return water_.f; }
  const Components<D>& force() const { return water_.f; }
  const Field& pressure() const { return multigrid().pressure(); }  ///< [Pa]
  const Openings<D>& openings() const { return water_.openings; }
  const Multigrid<D>& multigrid() const { return projection_.multigrid(); }
  double density() const { return water_.density; }
  double viscosity() const { return water_.viscosity; }
  const Grid<D>& grid() const { return water_.grid; }
  bool predicted() const { return stage_ != Stage::projected; }  ///< project() is due
  double step() const { return step_; }                ///< given to the last predict() [s]
  double step_before() const { return step_before_; }  ///< to the one before, 0 if none [s]

  /// Open fractions changed in the planes [k0, k1) of this rank; `flipped` if some did at once.
  /// Between steps.
  void openings_changed(int k0, int k1, bool flipped);

  /// On return velocity() holds u* = u + dt (convection + viscosity), without pressure and force,
  /// and u* = u_o on closed faces. The step may change from call to call. Once no face has flipped
  /// for two steps, unless a force acts, the viscous solve holds the last pressure gradient, so
  /// that walls keep their velocity with it; on return it is taken out again.
  void predict(double dt);

  /// Between predict() and project().
  ProvisionalVelocity<D> provisional() const;

  /// Keeps u*, to be called between predict() and project().
  void keep_prediction();
  /// Brings back the u* that was kept in this step, so that project() can follow again with another
  /// force(). It then starts from the last pressure.
  void return_to_prediction();

  /// On return Report::divergence is at most `tolerance` and velocity() is u at the new time,
  /// ghosts current. The pressure includes the reaction to force().
  Report project(double tolerance, int max_cycles);

  /// Forgets pressure, force and the steps so far; the velocity stays.
  void restart();
  /// What goes on from step to step; between steps. After reading, the openings are taken up as
  /// they are now.
  void state(Archive& archive);

  /// Ghosts of the velocity from other ranks and from the sides (after setting an initial state).
  void refresh_ghosts() { water_.refresh_ghosts(); }

 private:
  /// What velocity() is.
  enum class Stage {
    projected,  ///< u of a whole number of steps
    predicted,  ///< u*
    returned,   ///< u*, after a projection of this step
  };

  FlowFields<D> water_;
  Projection<D> projection_;
  Prediction<D> prediction_;
  Components<D> kept_;     ///< u*; allocated by the first keep_prediction()
  bool has_kept_ = false;  ///< the u* of this step
  Stage stage_ = Stage::projected;
  double step_ = 0, step_before_ = 0;
};

}  // namespace washtub
