#pragma once
#include <cmath>

#include "flow/pressure/multigrid.hpp"
#include "support/water_box.hpp"

namespace washtub::testing {

/// The pressure problem alone: a box, the solids in it and the solver.
template <int D>
struct MaskedPoisson {
  Grid<D> grid;
  DomainMapping<D> mapping;
  Multigrid<D> mg;
  double density;

  MaskedPoisson(const Mesh<D>& mesh, std::vector<Solid> solids, double density_ = 1,
                const Parallel& parallel = Parallel())
      : grid(mesh, parallel, granularity(mesh)),
        mapping(grid, std::move(solids)),
        mg(grid, density_, mapping.open()),
        density(density_) {}

  /// Calls visit(local cell, memory position) for the live cells of this rank.
  template <class Visit>
  void for_live(Visit&& visit) const {
    const auto& block = grid.block();
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (int i = 0; i < block.width(); ++i) {
          Index<D> c{};
          c[0] = i;
          if constexpr (D == 3) c[1] = j;
          c[D - 1] = k;
          const long p = block.at(c);
          if (mg.inverse_diagonal()[p] > 0) visit(c, p);
        }
  }
  /// A x of one cell, written down anew from the definition in multigrid.hpp.
  double applied(const Field& x, long p) const {
    double sum = 0;
    for (int d = 0; d < D; ++d) {
      const long s = grid.block().stride[d];
      const float* open = mapping.open()[d];
      const double g = 1 / (density * grid.mesh().h[d] * grid.mesh().h[d]);
      sum += g * (open[p] * (x[p] - x[p - s]) + open[p + s] * (x[p] - x[p + s]));
    }
    return sum;
  }
  /// Sets the source to source(position) in the live cells.
  template <class Source>
  void set_source(Source&& source) {
    for_live([&](const Index<D>& c, long p) { mg.source()[p] = source(grid.position(c)); });
  }
  /// Takes the mean over the live cells of all ranks out of the source.
  void make_compatible() {
    std::array<double, 2> sums{};
    for_live([&](const Index<D>&, long p) { sums[0] += mg.source()[p], sums[1] += 1; });
    grid.parallel().sum(std::span<double>(sums));
    for_live([&](const Index<D>&, long p) { mg.source()[p] -= sums[0] / sums[1]; });
  }
  /// Largest |b - A p| of all ranks, with any source.
  double residual(const Field& source) const {
    double largest = 0;
    for_live([&](const Index<D>&, long p) {
      largest = std::max(largest, std::abs(source[p] - applied(mg.pressure(), p)));
    });
    return grid.parallel().max(largest);
  }
};

/// Smooth waves with noise on top, a function of the place alone.
inline double rough_source(const Vec<3>& x) {
  const double noise = std::sin(1e4 * (12.9898 * x[0] + 78.233 * x[1] + 37.719 * x[2])) * 43758.5;
  return std::sin(7 * x[0] + 4 * x[1]) * std::cos(17 * x[2] - 3 * x[0]) +
         0.3 * (noise - std::floor(noise) - 0.5);
}

}  // namespace washtub::testing
