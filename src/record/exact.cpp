#include "record/exact.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

template <int D>
bool in_water(const std::vector<SolidPose>& solids, const Vec<D>& x) {
  return std::all_of(solids.begin(), solids.end(),
                     [&](const SolidPose& solid) { return solid.psi(in_space<D>(x)) < 0; });
}

}  // namespace

template <int D>
double ExactSolution<D>::error(double u, int d, const Vec<D>& x, double t) const {
  const Vec<D> exact = field_(x, t);
  const double scale = relative_ ? exact.norm() : 1;
  return scale > 0 ? std::abs(u - exact[d]) / scale : -1;
}

template <int D>
VelocityError ExactSolution<D>::compare(const Simulation<D>& simulation) const {
  const auto& grid = simulation.grid();
  const auto& block = grid.block();
  const auto open = simulation.mapping().open();
  const auto solids = simulation.mapping().poses();
  double largest = 0;
  std::array<double, 2> sums{};  // of the squares, and of the faces
  for (int d = 0; d < D; ++d)
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (int i = 0; i < block.width(); ++i) {
          Index<D> c{};
          c[0] = i;
          if constexpr (D == 3) c[1] = j;
          c[D - 1] = k;
          const long p = block.at(c);
          if (open[d][p] <= 0 || (c[d] == 0 && grid.at_side(d, 0))) continue;
          const Vec<D> x = grid.position(c, d);
          if (!in_water<D>(solids, x)) continue;
          const double e = error(simulation.flow().velocity()[d][p], d, x, simulation.time());
          if (e < 0) continue;
          largest = std::max(largest, e);
          sums[0] += e * e;
          sums[1] += 1;
        }
  grid.parallel().sum(std::span<double>(sums));
  return {grid.parallel().max(largest), sums[1] > 0 ? std::sqrt(sums[0] / sums[1]) : 0};
}

template class ExactSolution<2>;
template class ExactSolution<3>;

}  // namespace washtub
