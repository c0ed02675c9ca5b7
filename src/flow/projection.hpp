#pragma once
#include <vector>

#include "flow/fields.hpp"
#include "flow/pressure/multigrid.hpp"
#include "flow/warm_start.hpp"

namespace washtub {

/// Makes the velocity free of divergence by the pressure, Eq. (2).
template <int D>
class Projection {
 public:
  explicit Projection(FlowFields<D>& water);

  struct Report {
    SolveReport pressure;
    /// Of |div u| h / U in the cells of water, h the largest spacing, U the largest speed: the root
    /// of the mean square, or a hundredth of the largest where that is more.
    double divergence = 0;
    double speed = 0;    ///< largest |u| component on faces [m/s]
    double courant = 0;  ///< largest sum over axes of |u_d| / h_d [1/s]
    double kinetic = 0;  ///< kinetic energy of the water [J] (per metre in 2-D)
  };
  /// How well and how long to solve.
  struct Accuracy {
    double divergence;  ///< bound of Report::divergence
    int max_cycles;
  };
  /// From u* to u of the new time, see Flow::project(). `again`: the last pressure was of the same
  /// step, and the solve starts from it.
  Report project(double dt, const Accuracy& accuracy, bool again);

  /// Takes up open fractions that changed in the planes [k0, k1) of this rank; `flipped` if some
  /// did at once.
  void openings_changed(int k0, int k1, bool flipped);

  void restart();  ///< forgets the pressure
  /// After reading, the openings are taken up as they are now.
  void state(Archive& archive);

  const Multigrid<D>& multigrid() const { return multigrid_; }
  const WarmStart& warm_start() const { return warm_start_; }

 private:
  struct Extremes {
    double speed, force;  ///< largest component [m/s, N/m^3]
  };
  void start_new_cells(Field& pressure, int k0, int k1);
  double mean_around(const Field& pressure, long cell) const;
  void add_force_row(int j, int k, double dt, Extremes& largest);
  void start_row(int j, int k, double dt, const WarmStart::Guess& guess, bool again);
  void correct_row(int j, int k, double dt, Report& report);
  double start(double dt, bool again);
  void correct(double dt, Report& report);

  FlowFields<D>& water_;
  Multigrid<D> multigrid_;
  Field before_;  ///< pressure of the step before [Pa]
  WarmStart warm_start_;
  std::vector<double> row_buffer_;
};

}  // namespace washtub
