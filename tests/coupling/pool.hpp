#pragma once
#include <algorithm>
#include <vector>

#include "cloth/thread.hpp"
#include "coupling/coupling.hpp"
#include "coupling/faces.hpp"
#include "support/water_box.hpp"

namespace washtub::testing {

/// A periodic box of water with cloth in it.
template <int D>
struct Pool {
  WaterBox<D> water;
  Cloth<D> cloth;
  Coupling<D> coupling;

  Pool(const Mesh<D>& mesh, double viscosity, const Cloth<D>& cloth_, Scheme scheme,
       const Parallel& parallel = Parallel(), const ContactSettings& contact = {})
      : water(setup(mesh, viscosity), parallel),
        cloth(cloth_),
        coupling(water.flow, cloth, water.mapping, Kernel::cosine, {}, scheme, 2, nullptr,
                 contact) {}

  static WaterSetup<D> setup(const Mesh<D>& mesh, double viscosity) {
    WaterSetup<D> s{mesh, {}, 1000, viscosity};
    for (auto& axis : s.sides)
      for (auto& side : axis) side.kind = Side<D>::Kind::periodic;
    return s;
  }
  typename Coupling<D>::Report step(double dt, double tolerance = 1e-6) {
    water.move_solids(dt);
    water.flow.predict(dt);
    coupling.push();
    do kinetic = water.flow.project(tolerance, 60).kinetic;
    while (coupling.again());
    return coupling.move();
  }
  double elastic() const {
    double w = 0;
    for (const auto& g : cloth.groups)
      for (int p = 0; p < g.pieces; ++p) w += g.sheet.energy(cloth.piece(g, p));
    return w;
  }
  /// Of the water and of the mass of the cloth beyond it [kg m/s].
  Vec<D> momentum() const {
    Vec<D> p = water.flow.density() * total<D>(water.grid, water.flow.velocity());
    for (const auto& g : cloth.groups)
      for (int i = 0; i < g.nodes(); ++i)
        p += g.sheet.material.excess_mass *
             g.sheet.area[static_cast<std::size_t>(i % g.sheet.nodes())] *
             cloth.velocity[static_cast<std::size_t>(g.first_node + i)];
    return p;
  }
  /// Of the cloth on the water [N].
  Vec<D> force() const { return total<D>(water.grid, water.flow.force()); }
  double largest_force() const {
    double f = 0;
    for (const auto& e : cloth.elastic) f = std::max(f, e.norm());
    return f;
  }
  double energy() const { return elastic() + kinetic; }

  double kinetic = 0;  ///< of the water after the last step [J]
};

/// A thread of 9 nodes and 0.4 m in the middle of the unit square, stretched `by`.
inline Cloth<2> stretched_thread(double by, double excess = 0, double stiffness = 200,
                                 const std::vector<int>& pinned = {}) {
  std::vector<Vec<2>> where;
  for (int i = 0; i < 9; ++i) where.emplace_back(0.5 + 0.05 * by * (i - 4), 0.5 + 0.01 * i);
  Cloth<2> cloth;
  cloth.add(make_thread(9, 0.05, {stiffness, 0, 1e-3, 0, 0, excess, 1e-3}), where, pinned);
  return cloth;
}

inline Mesh<2> square(int n = 32) { return cubic_mesh<2>({0, 0}, 1, n, true); }

}  // namespace washtub::testing
