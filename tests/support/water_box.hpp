#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "flow/flow.hpp"
#include "solid/surface_water.hpp"

namespace washtub::testing {

template <int D>
Openings<D> openings(const DomainMapping<D>& mapping) {
  return {mapping.open(), mapping.held()};
}

/// A box from `lower` with n cells of width h along every axis.
template <int D>
Mesh<D> cubic_mesh(const Vec<D>& lower, double width, int n, bool periodic = false) {
  Mesh<D> m{lower, Vec<D>::Constant(width / n), {}, {}};
  m.cells.fill(n);
  m.periodic.fill(periodic);
  return m;
}

/// What a box of water is made of.
template <int D>
struct WaterSetup {
  Mesh<D> mesh;
  std::vector<Solid> solids{};
  double density = 1, viscosity = 1;
  Heaviside heaviside{};
  SidePairs<D> sides{};
};

/// Water and solids in a box, moved together.
template <int D>
struct WaterBox {
  Grid<D> grid;
  DomainMapping<D> mapping;
  SurfaceWater<D> surface_water;
  Flow<D> flow;
  double t = 0;

  explicit WaterBox(const WaterSetup<D>& s, const Parallel& parallel = Parallel())
      : grid(s.mesh, parallel, granularity(s.mesh)),
        mapping(grid, s.solids, s.heaviside),
        surface_water(grid, mapping, s.density),
        flow(grid, s.density, s.viscosity, s.sides, openings(mapping)) {}

  /// Solids to time t + dt, with their velocity on the faces they close.
  void move_solids(double dt) {
    t += dt;
    const auto change = mapping.update(t);
    const auto [k0, k1] = mapping.moving_planes();
    if (change.any) flow.openings_changed(k0, k1, change.flipped);
    impose();
  }
  void impose() { mapping.impose(flow.velocity()); }
  typename Flow<D>::Report step(double dt, double tolerance = 1e-4, int max_cycles = 60) {
    move_solids(dt);
    flow.predict(dt);
    return flow.project(tolerance, max_cycles);
  }
  WaterState<D> water() const {
    WaterState<D> w{{}, flow.pressure().data(), {}, flow.density(), flow.viscosity()};
    for (int d = 0; d < D; ++d) {
      w.velocity[d] = flow.velocity()[d].data();
      w.force[d] = flow.force()[d].data();
    }
    return w;
  }
  /// What the water does to a solid, this rank's share.
  SurfaceLoads<D> loads(std::size_t solid) const {
    return surface_loads<D>(grid, mapping, solid, water());
  }
  double torque(std::size_t solid) const {
    return grid.parallel().sum(loads(solid).total().torque);
  }

  /// Calls visit(local cell, memory position) for every cell of this rank.
  template <class Visit>
  void for_cells(Visit&& visit) const {
    const auto& block = grid.block();
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (int i = 0; i < block.width(); ++i) {
          Index<D> c{};
          c[0] = i;
          if constexpr (D == 3) c[1] = j;
          c[D - 1] = k;
          visit(c, block.at(c));
        }
  }
  /// Calls visit(axis, position in space, memory position) for every open face of this rank.
  template <class Visit>
  void for_open_faces(Visit&& visit) const {
    const auto open = mapping.open();
    for (int d = 0; d < D; ++d)
      for_cells([&](const Index<D>& c, long p) {
        if (open[d][p] > 0) visit(d, grid.position(c, d), p);
      });
  }
  /// Sets u = field(axis, position) on the open faces, the solids' velocity on the others.
  template <class FieldOf>
  void start_from(FieldOf&& field) {
    for_open_faces([&](int d, const Vec<D>& x, long p) { flow.velocity()[d][p] = field(d, x); });
    impose();
    flow.refresh_ghosts();
  }
  /// Largest |u - field(axis, position)| over the open faces of all ranks.
  template <class FieldOf>
  double error(FieldOf&& field) const {
    double largest = 0;
    for_open_faces([&](int d, const Vec<D>& x, long p) {
      largest = std::max(largest, std::abs(flow.velocity()[d][p] - field(d, x)));
    });
    return grid.parallel().max(largest);
  }
  /// (div u) of the cell at memory position p, from its faces [1/s].
  double divergence(long p) const {
    double sum = 0;
    for (int d = 0; d < D; ++d) {
      const auto& u = flow.velocity()[d];
      sum += (u[p + grid.block().stride[d]] - u[p]) / grid.mesh().h[d];
    }
    return sum;
  }
  /// Largest |div u| over the water cells of all ranks [1/s].
  double largest_divergence() const {
    double largest = 0;
    for_cells([&](const Index<D>&, long p) {
      if (flow.multigrid().inverse_diagonal()[p] > 0)
        largest = std::max(largest, std::abs(divergence(p)));
    });
    return grid.parallel().max(largest);
  }
};

}  // namespace washtub::testing
