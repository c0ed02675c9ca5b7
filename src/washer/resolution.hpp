#pragma once
#include <optional>
#include <string>

#include "case/case.hpp"
#include "flow/flow.hpp"
#include "solid/mapping.hpp"

namespace washtub {

/// How well the grid resolves the water's motion: at an instant, or at the worst of several.
///
/// Measured on the reference washes (largest after the start, h the longest edge of a cell):
///
///   | density omega_max r_o h / viscosity | grid scale, 2-D | 3-D  | speed / driving speed |
///   |                             43 - 87 |            0.02 | 0.10 | 1.3 - 1.8             |
///   |                           430 - 870 |            0.07 | 0.26 | 2.1 - 2.4             |
///   |                         4300 - 8700 |            0.22 | 0.37 | 2.9 - 3.2             |
///   |                               87000 |                 | 0.39 | 3.9                   |
struct Resolution {
  double grid_scale = 0;     ///< largest share of grid_scale_energy() of any axis
  double speed = 0;          ///< largest velocity component [m/s]
  double driving_speed = 0;  ///< of what moves the water [m/s]; 0: unknown

  static constexpr double grid_scale_bound = 0.15, speed_bound = 3;
  static constexpr bool of_doubles = true;

  /// Speed over the driving speed; 0 where that is unknown.
  double speed_ratio() const { return driving_speed > 0 ? speed / driving_speed : 0; }
  bool resolved() const { return grid_scale <= grid_scale_bound && speed_ratio() <= speed_bound; }
  void take_worst(const Resolution& other);
};

/// Largest speed of a solid's surface, a moving side or an inflow in the course of the run [m/s];
/// where there is none, `start`: that of the water at t = 0. Collective.
template <int D>
double driving_speed(const Grid<D>& grid, const DomainMapping<D>& mapping,
                     const SidePairs<D>& sides, double start);

/// Resolution of the flow as it is. Collective.
template <int D>
Resolution find_resolution(const Flow<D>& flow, double driving_speed, double speed);

/// One paragraph on a flow that the grid does not resolve: what was measured, what it means, what
/// to try; none where all is well.
std::optional<std::string> unresolved(const Resolution& worst, const Case& whole);

/// What a run of the case will show if the grid cannot resolve the thin layers and the eddies that
/// its speed and viscosity make; none where nothing is to be feared, or nothing is known.
std::optional<std::string> foresee_unresolved(const Case& whole);

/// All that can be said beforehand of what the grid does not resolve, a paragraph each.
std::vector<std::string> doubts(const Case& whole);

}  // namespace washtub
