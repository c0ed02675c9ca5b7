#pragma once
#include <array>

#include "grid/grid.hpp"

namespace washtub {

/// Condition on one side of the box.
template <int D>
struct Side {
  enum class Kind { wall, slip, periodic };
  Kind kind = Kind::wall;            ///< wall: no slip, moving with `velocity`
  Vec<D> velocity = Vec<D>::Zero();  ///< tangential velocity of a wall [m/s]
};

/// Fills the ghosts beyond the sides of the box so that tangential velocities take the wall's value
/// (or no gradient, on slip sides) on the side itself.
template <int D>
class Sides {
 public:
  Sides(const Grid<D>& grid, const std::array<std::array<Side<D>, 2>, D>& sides);

  /// Ghosts that mirror row (j, k) of velocity component c.
  void mirror_row(int c, double* u, int j, int k) const;
  /// Ghosts of a whole component.
  void mirror(int c, double* u) const;

 private:
  void mirror_onto(int c, int axis, int side, const double* from, double* to) const;

  const Grid<D>& grid_;
  std::array<std::array<Side<D>, 2>, D> sides_;
  std::array<std::array<bool, 2>, D> here_{};
};

}  // namespace washtub
