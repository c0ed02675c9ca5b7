#pragma once
#include <vector>

#include "cloth/cloth.hpp"
#include "solid/mapping.hpp"

namespace washtub {

/// Keeps cloth out of solids and inside the box: a node nearer than half a cell to a surface is put
/// back to that distance along the surface normal and loses the velocity into the surface.
template <int D>
class Barrier {
 public:
  Barrier(const Grid<D>& grid, const DomainMapping<D>& mapping, int nodes);

  struct Report {
    int touched = 0;         ///< nodes put back
    double penetration = 0;  ///< deepest a node had entered a solid before that [m]
  };
  /// On return no node lies inside a solid or beyond a side of the box. `dt`: time since last call.
  Report hold(Cloth<D>& cloth, double dt);

 private:
  bool hold_from_solids(Vec<D>& x, Vec<D>& v, double& clearance, Report& report) const;
  bool hold_from_sides(Vec<D>& x, Vec<D>& v) const;
  double margin(const Vec<D>& normal) const;

  const Grid<D>& grid_;
  const DomainMapping<D>& mapping_;
  std::vector<double> clearance_;  ///< distance that may pass before a node is looked at again [m]
};

}  // namespace washtub
