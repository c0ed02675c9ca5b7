#pragma once
#include <functional>

#include "flow/passing_water.hpp"
#include "flow/sides.hpp"
#include "grid/grid.hpp"
#include "grid/held_faces.hpp"

namespace washtub {

/// How solids stand in the grid, as the flow needs to know it.
template <int D>
struct Openings {
  std::array<const float*, D> open;  ///< open fraction of each face, ghosts included
  /// Faces whose velocity is held, in part, to what a wall asks for, along each axis.
  std::array<const HeldFaces*, D> held{};
};

/// The water that the parts of a Flow work on: what it is, where it may go, its fields.
template <int D>
struct FlowFields {
  /// @throws InputError when water enters through a side and none lets it out.
  FlowFields(const Grid<D>& grid, double density, double viscosity, const SidePairs<D>& sides,
             const Openings<D>& openings);

  /// See Flow::set_velocity().
  void set_velocity(const std::function<Vec<D>(const Vec<D>&)>& field);
  /// Ghosts of the velocity from other ranks.
  void exchange();
  /// Ghosts of the velocity from other ranks and from the sides.
  void refresh_ghosts();
  void state(Archive& archive);
  /// On the held faces of a row: from the velocity of the water to the mean over the face, which
  /// continuity knows; what has no passage goes with the wall.
  void to_passage(int j, int k);
  /// The other way, on all of them, with what the mean has changed by since.
  void from_passage();
  /// The values of u.
  std::array<double*, D> velocities();

  const Grid<D>& grid;
  double density;    ///< [kg/m^3]
  double viscosity;  ///< [Pa s]
  SidePairs<D> conditions;
  Sides<D> sides;
  PassingWater<D> passing;
  Openings<D> openings;
  Components<D> u;                          ///< [m/s]
  std::array<std::vector<double>, D> past;  ///< u less that of the wall, on held faces [m/s]
  Components<D> f;                          ///< force density of the cloth on the water [N/m^3]
  double speed = 0;  ///< largest velocity component at the end of the last step [m/s]
};

}  // namespace washtub
