#pragma once

namespace washtub {

/// What keeps cloth apart from cloth.
enum class ContactScheme {
  none,    ///< nothing but the water between, as in the paper
  layers,  ///< repulsion within a range, a least gap, and a guarantee against crossing
};

struct ContactSettings {
  ContactScheme scheme = ContactScheme::none;
  double range = 0;     ///< d0, within which sheets repel each other [m]
  double pressure = 0;  ///< P of the repulsion [Pa]
  double rise = 0;      ///< time over which it rises at the start [s]
  double gap = 0;       ///< that sheets keep [m]
  /// Water that the cloth carries along, over its area [kg/m^2]: bounds what an explicit force
  /// does.
  double areal_mass = 0;
  /// A node closes at most 1 - exp(-dt/solid_time) of its gap to a solid in a step [s]; 0: all.
  double solid_time = 0;
  double permeability =
      0;  ///< the largest of any cloth [m/(s Pa)], which bounds explicit forces too
};

}  // namespace washtub
