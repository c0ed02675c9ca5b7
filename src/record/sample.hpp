#pragma once
#include <array>
#include <vector>

#include "base/vec.hpp"
#include "measure/rainflow.hpp"
#include "measure/stress.hpp"
#include "record/quality.hpp"

namespace washtub {

/// The last step before a sample.
struct StepSample {
  double number = 0;      ///< steps since the start
  double length = 0;      ///< [s]
  double courant = 0;     ///< sum over axes of |u| dt / h, largest
  double divergence = 0;  ///< |div u| h / U, largest
  double cycles = 0;      ///< of the pressure solver
  double speed = 0;       ///< largest velocity component [m/s]
  double kinetic = 0;     ///< energy of the water [J], per metre in 2-D
  double strain = 0;      ///< largest |E| of an edge
  double slip = 0;        ///< rms, of the cloth against the water [m/s]
  double newton = 0;      ///< steps of the cloth's solver
};

/// What one solid felt since the sample before; torques of the water on it, per metre in 2-D.
struct SolidSample {
  double angle = 0;   ///< [rad]
  double speed = 0;   ///< mean since the sample before [rad/s]
  double power = 0;   ///< that it gave to the water: mean of -torque times speed over the steps [W]
  double torque = 0;  ///< mean since then if it turns, else now [N m]
  double rms_torque = 0;  ///< root of the mean square over the steps since then, if it turns [N m]
  double friction = 0;    ///< skin friction part, now [N m]
  double pressure = 0;    ///< pressure part, now [N m]
  double convection = 0;  ///< momentum carried into the staircase, now [N m]
  Vec<3> force = Vec<3>::Zero();  ///< of the water on it, all parts, now [N]
};

/// How far the velocity is from a known one.
struct VelocityError {
  double largest = 0;
  double rms = 0;
};

/// What of the cloth's area a quantile of the stress stands for.
inline constexpr std::array<double, 3> stress_parts = {0.5, 0.9, 0.99};
using StressQuantiles = std::array<double, 3>;

/// Centre and stress of one piece of cloth, or of a group.
struct PieceSample {
  Vec<2> centre;                ///< (r, z) [m]
  StressParts stress;           ///< area means, membrane strains low-passed [Pa]
  double tension = 0;           ///< its membrane part along edges, of those that are stretched [Pa]
  double compression = 0;       ///< of those that are compressed [Pa]
  double raw_stress = 0;        ///< the total with the strains of the instant [Pa]
  StressQuantiles quantiles{};  ///< of groups only: what parts of its area stay below [Pa]
  /// Of groups only: strain cycles over strain_ranges since the sample before, per edge and time
  /// [1/s].
  Rainflow::Counts strain_cycles{};
};

/// One row of history: the state at an instant and the means since the one before.
struct Sample {
  double time = 0;
  StepSample step;
  std::vector<SolidSample> solids;
  std::vector<PieceSample> pieces;
  std::vector<PieceSample> groups;                      ///< means over the pieces of each
  StressParts stress;                                   ///< mean over the pieces [Pa]
  double tension = 0, compression = 0, raw_stress = 0;  ///< likewise
  StressQuantiles quantiles{};                          ///< of all cloth [Pa]
  Rainflow::Counts strain_cycles{};                     ///< likewise [1/s]
  Vec<2> centre = Vec<2>::Zero();                       ///< (r, z) of all pieces [m]
  std::vector<Vec<3>> probes;                           ///< places of the case's probes [m]
  double enclosed_area = 0;                             ///< mean over the rings [m^2]
  VelocityError error;  ///< from the exact velocity, where the case gives one
  QualitySample quality;
};

}  // namespace washtub
