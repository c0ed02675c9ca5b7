#pragma once
#include <array>
#include <vector>

#include "base/vec.hpp"
#include "io/frame_reader.hpp"

namespace washtub {

/// The water on a lattice of cells, x fastest, as a page carries it.
struct Lattice {
  std::array<int, 3> cells{};
  int axes = 3;                               ///< components of the velocity: 2 in plane cases
  std::vector<float> velocity;                ///< [axis][z][y][x], m/s
  std::vector<float> vorticity;               ///< [y][x] in plane cases, else empty [1/s]
  std::vector<float> solid;                   ///< 1 - largest open fraction of the cell's faces
  std::vector<FieldValues<float>> scalars{};  ///< all others that the frames have

  std::size_t size() const { return solid.size(); }
};

/// `dimension` 2 or 3; `spacing` of the cells [m] and the directions in which the box repeats
/// itself are for the vorticity.
Lattice lattice(const WaterFrame& water, int dimension, const Vec<3>& spacing,
                std::array<bool, 2> periodic);

/// Cells of twice the size along every axis that has more than one: mean over the open part of the
/// cells in each, and mean of `solid`. At an odd number of cells the last one keeps
/// only its inner half.
Lattice coarsen(const Lattice& fine);

/// Cells of a lattice coarsened so many times.
std::array<int, 3> coarse_cells(std::array<int, 3> cells, int times);

/// z component of the curl by central differences, one-sided at the ends [1/s].
std::vector<float> vorticity(const std::vector<float>& velocity, std::array<int, 3> cells,
                             const Vec<3>& spacing, std::array<bool, 2> periodic);

}  // namespace washtub
