#pragma once
#include <array>
#include <cmath>

#include "base/vec.hpp"

namespace washtub {

/// The whole Cartesian grid: a box of equal cells, with its own spacing along each axis.
/// Pressure lives in cell centres, velocity component d on the lower faces normal to axis d (MAC).
template <int D>
struct Mesh {
  Vec<D> lower;                    ///< lower corner of the box [m]
  Vec<D> h;                        ///< spacing along each axis [m]
  Index<D> cells;                  ///< cells along each axis
  std::array<bool, D> periodic{};  ///< axes along which the box repeats

  Vec<D> size() const {
    Vec<D> s;
    for (int d = 0; d < D; ++d) s[d] = h[d] * cells[d];
    return s;
  }
  /// Whole periods of the box in the way between two points, which is then at most half a period.
  Vec<D> periods_in(const Vec<D>& way) const {
    Vec<D> whole = Vec<D>::Zero();
    for (int d = 0; d < D; ++d)
      if (periodic[d]) whole[d] = h[d] * cells[d] * std::round(way[d] / (h[d] * cells[d]));
    return whole;
  }
  double cell_volume() const { return h.prod(); }
  /// Centre of the lower face d of cell c (d = -1: centre of the cell) [m].
  Vec<D> position(const Index<D>& c, int d = -1) const {
    Vec<D> x;
    for (int e = 0; e < D; ++e) x[e] = lower[e] + h[e] * (c[e] + (e == d ? 0.0 : 0.5));
    return x;
  }
};

}  // namespace washtub
