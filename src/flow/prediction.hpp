#pragma once
#include <vector>

#include "flow/fields.hpp"
#include "flow/pressure/multigrid.hpp"

namespace washtub {

/// Momentum without the force of this step: Adams-Bashforth 3/2 convection in divergence form and
/// Crank-Nicolson viscosity. Keeps the convection of the step before.
template <int D>
class Prediction {
 public:
  /// @param multigrid  knows the cells in which water is, and the pressure
  Prediction(FlowFields<D>& water, const Multigrid<D>& multigrid);

  /// On return u = u* and its ghosts are current, see Flow::predict(). Ghosts have to be before.
  /// @param dt      [s]
  /// @param before  the step before, 0 in the first one [s]
  /// @param held    the viscous solve holds the last pressure gradient
  void advance(double dt, double before, bool held);

  /// Forgets the convection in cells of the planes [k0, k1) that are now solid.
  void openings_changed(int k0, int k1);

  void restart();  ///< forgets it everywhere
  void state(Archive& archive) { archive.grids("convection", convection_, water_.grid.part()); }

 private:
  /// Weights of the right-hand side of the viscous solve.
  struct Weights {
    double now, before;  ///< of the convection of this step and the one before [s]
    double push;         ///< dt/rho of the last pressure gradient, or 0 [m^3 s/kg]
    double step;         ///< share of the explicit step in the guess
  };
  template <int c, bool pushed>
  void start_row(int j, int k, const Weights& weights);
  void start_rows(int j, int k, const Weights& weights);
  double row_share(int j, int k) const;
  double clash_share(int axis) const;
  auto momentum(int c, int j, int k, const double* x) const;
  template <class Share>
  void relax_held(int c, int j, int k, const double* x, double diagonal, Share&& share,
                  double* fresh);
  void leave_guess(int c, int j, int k, double step);
  void relax_row(int c, int j, int k, int colour, double omega);
  void take_outer_ghosts();
  void take_push_back(int j, int k, double push);

  FlowFields<D>& water_;
  const Multigrid<D>& multigrid_;
  Components<D> rhs_, guess_, convection_;
  std::array<double, D> diffusion_{};  ///< nu dt / (2 h^2)
  double diagonal_ = 1;                ///< of the momentum operator, 1 + 2 sum of diffusion_
  double wall_diffusion_ = 0;          ///< nu dt [m^2]
  std::vector<double> row_buffer_;
  std::array<std::vector<double>, 2> colour_;  ///< 1 on the cells of a colour, else 0
  std::array<bool, D> odd_{};  ///< axes along which first and last are neighbours of one colour
};

}  // namespace washtub
