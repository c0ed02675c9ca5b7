#pragma once
#include "solid/loads.hpp"

namespace washtub {

/// The water among the faces that are not fully open, solid by solid. What a solid receives in a
/// step is what its water had, what joined it and what flowed in by its loads, less what it has:
///   impulse = momentum(before) + joined + dt loads - momentum(after) .
/// The faces count in full with the velocity u_o of the solid and by DomainMapping::content() with
/// that past it, u - u_o; the water that the solid displaces is taken off exactly, so that a solid
/// that turns with the water feels nothing of the faces that it opens and closes.
template <int D>
class SurfaceWater {
 public:
  /// @param density  of the water [kg/m^3]
  SurfaceWater(const Grid<D>& grid, const DomainMapping<D>& mapping, double density);

  /// Of a turning solid [N s], and its moment about the solid's axis [N m s]; this rank's share.
  /// Closed faces have to go with the solid, see DomainMapping::impose().
  Load<D> momentum(std::size_t solid, const std::array<Field, D>& u) const;
  /// Of the water in faces that are no longer fully open since the last DomainMapping::update(),
  /// less those that are again. The velocity is that before the solids' is imposed.
  Load<D> joined(std::size_t solid, const std::array<Field, D>& u) const;

 private:
  /// Integrals over the displaced water, in the body frame at t = 0.
  struct Displaced {
    Vec<2> first = Vec<2>::Zero();  ///< of the place about the axis [kg m]
    double second = 0;              ///< of its square [kg m^2]
  };
  Displaced integrate(std::size_t solid) const;
  double share_inside(std::size_t solid, const Vec<D>& x) const;

  const Grid<D>& grid_;
  const DomainMapping<D>& mapping_;
  double cell_mass_;  ///< [kg]
  std::vector<Displaced> displaced_;
};

}  // namespace washtub
