#pragma once
#include <array>

#include "grid/grid.hpp"

namespace washtub {

/// Condition on one side of the box.
template <int D>
struct Side {
  enum class Kind {
    wall,      ///< no slip, moving with the tangential part of `velocity`
    slip,      ///< no normal velocity, no friction
    periodic,  ///< the far side is beyond
    inflow,    ///< water enters with `velocity`, uniform over the side
    outflow,   ///< every component leaves by a convective condition
    far_field  ///< lateral side of App. B: water may pass, the viscous stress is continuous
  };
  Kind kind = Kind::wall;
  Vec<D> velocity = Vec<D>::Zero();  ///< of a wall or of the water that enters [m/s]
};

template <int D>
using SidePairs = std::array<std::array<Side<D>, 2>, D>;

/// Fills the ghosts of tangential velocities beyond the sides of the box: their mean with the value
/// inside is that of the wall or inflow; slip sides have no gradient; far fields no second
/// derivative across the side. Ghosts beyond an outflow are kept, PassingWater moves them.
template <int D>
class Sides {
 public:
  Sides(const Grid<D>& grid, const SidePairs<D>& sides);

  /// Ghosts that follow from row (j, k) of velocity component c and the row next to it.
  void mirror_row(int c, double* u, int j, int k) const;
  /// Ghosts of a whole component.
  void mirror(int c, double* u) const;

 private:
  /// ghost = twice velocity + near u_1 + next u_2, with u_1, u_2 the values inside.
  struct Reflection {
    bool here = false;  ///< this rank's block has such ghosts
    Vec<D> twice = Vec<D>::Zero();
    double near = 0, next = 0;
    double operator()(int c, double u1, double u2) const {
      return twice[c] + near * u1 + next * u2;
    }
  };
  static Reflection reflection(const Side<D>& side);
  void mirror_onto(int c, const Reflection& r, double* row, long out) const;

  const Grid<D>& grid_;
  std::array<std::array<Reflection, 2>, D> reflections_;
};

}  // namespace washtub
