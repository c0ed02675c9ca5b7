#pragma once
#include "solid/shape.hpp"

namespace washtub {

/// Agitator of a deep-water tub about the z axis, on the floor z = 0; all lengths in m.
struct Agitator3d {
  double rim_radius = 0;        ///< of the skirt
  double rim_height = 0;        ///< of the skirt at its rim
  double skirt_top_radius = 0;  ///< where the skirt's straight slope ends
  double skirt_top_height = 0;  ///< height there
  double hub_radius = 0;        ///< of the column and of the hemisphere on top of it
  double hub_height = 0;        ///< of the column, without the hemisphere
  int fins = 0;                 ///< upright plates, equally spaced, the first along +x
  double fin_half_thickness = 0;
  double fin_radius = 0;       ///< of the fin's outer edge
  double fin_root_height = 0;  ///< top edge at the hub; it falls linearly from there ...
  double fin_tip_height = 0;   ///< ... to this height at the outer edge
};

/// Agitator of a two-dimensional wash: a disc and straight fins with round ends; lengths in m.
struct Agitator2d {
  double hub_radius = 0;
  int fins = 0;           ///< equally spaced, the first along +x
  double fin_radius = 0;  ///< end of the fin's centre line; its round end lies beyond
  double fin_half_width = 0;
};

/// Proportions of the reference geometry for a tub of radius r_o and water depth H [m].
Agitator3d reference_agitator_3d(double tub_radius, double depth);
Agitator2d reference_agitator_2d(double tub_radius);

/// Skirt, hub and fins united. Below the floor the solid goes on straight down by the rim's radius,
/// so that inside it grad psi never points to a face that the floor closes anyway.
/// @throws InputError naming the parameter that is out of range
Shape shape(const Agitator3d& agitator);
/// Infinite along z in the hub; evaluate at z = 0.
/// @throws InputError naming the parameter that is out of range
Shape shape(const Agitator2d& agitator);

}  // namespace washtub
