#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "solid/solid.hpp"

namespace washtub {

/// Triangles that share their vertices, counter-clockwise seen from the water.
struct Surface {
  std::vector<std::array<float, 3>> vertices;           ///< [m]
  std::vector<std::array<std::uint32_t, 3>> triangles;  ///< numbers of vertices
};

/// What a surface is wanted of.
struct SurfaceBox {
  Vec<3> lower, upper;  ///< of the case [m]
  bool plane = false;   ///< solids as they are at z = 0, all along the box's z
};

/// The surface of a solid about its centre at angle 0, closed for moving solids and open where the
/// box cuts resting ones. Of moving ones it has all that enters the box at some angle. Edges are
/// sharp. None where there is no surface in the box.
std::optional<Surface> surface(const Solid& solid, const SurfaceBox& box);

/// Whether a solid of finite size reaches into the box, so that some of it should be seen.
bool reaches_into(const Solid& solid, const SurfaceBox& box);

/// The surface psi = 0 within a box, closed, or open where the box cuts it if `open`; cells about
/// `voxel` wide [m].
Surface surface(const Shape& shape, const Bounds& within, double voxel, bool open);

}  // namespace washtub
