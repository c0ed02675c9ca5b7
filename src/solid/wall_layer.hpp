#pragma once
#include "grid/grid.hpp"
#include "grid/held_faces.hpp"
#include "solid/solid.hpp"

namespace washtub {

/// The layer of water along the walls of a gradual mapping, one cell thick along the normal. With s
/// the distance of a face from the wall over the width of a cell, sum_d |n_d| h_d,
/// - the share s of the face is open: continuity knows u_o + s (u - u_o), which joins the velocity
/// of
///   the wall without a jump while it passes the face. Since u - u_o vanishes at the wall, this
///   changes what flows along it by a term of second order only;
/// - the momentum equation holds in full, with a drag towards u_o that makes the second difference
///   across the wall one that knows where the wall is: along each axis, where it lies nearer than
///   the next face, at the part theta of the spacing, nu/h^2 becomes nu/(theta h^2) (Gibou et al.
///   2002). The drag is taken at the new time.
/// Solids thinner than a cell are taken to be as thick as one, so that no water passes through.
template <int D>
class WallLayer {
 public:
  explicit WallLayer(const Grid<D>& grid) : grid_(grid) {}

  /// How far from a surface faces can be in the layer [m].
  double reach() const;
  /// Open fraction of a face in the water; where that is between 0 and 1, `face` is how it is held.
  /// @param x    its centre, where psi of the solid is `psi` < 0
  /// @param d    the axis that it is normal to
  float close(const SolidPose& solid, const Vec<3>& x, double psi, int d, HeldFace& face) const;

 private:
  double missing_thickness(const SolidPose& solid, const Vec<3>& x, double psi,
                           const Vec<3>& normal) const;

  const Grid<D>& grid_;
};

}  // namespace washtub
