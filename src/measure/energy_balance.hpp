#pragma once

namespace washtub {

/// What a run holds of energy at an instant, and what has changed it. Per metre in 2-D.
struct EnergyState {
  double time = 0;         ///< [s]
  double stored = 0;       ///< in water and cloth [J]
  double work = 0;         ///< of drives, sides and forces since the start [J]
  double dissipation = 0;  ///< rate at which viscosity turns energy into heat [W]
  static constexpr bool of_doubles = true;
};

/// What became of energy in a span of time.
struct EnergyBalance {
  double time = 0;  ///< length of the span [s]
  double work = 0;  ///< put in [J]
  double gain = 0;  ///< of what is stored [J]
  double heat = 0;  ///< from viscosity, by the trapezoidal rule between the instants [J]

  /// Put in and found nowhere [J]: what the scheme itself takes out of the motion, or, below zero,
  /// puts into it.
  double rest() const { return work - gain - heat; }
  /// The rest over the work or the heat, whichever is larger; 0 where there is neither.
  double share() const;
  void add(const EnergyState& before, const EnergyState& now);
  static constexpr bool of_doubles = true;
};

}  // namespace washtub
