#include "cloth/energy.hpp"

namespace washtub {

template <int D>
double energy(const Cloth<D>& cloth) {
  double sum = 0;
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      sum += g.sheet.energy(cloth.piece(g, p));
      for (int n = 0; n < g.sheet.nodes(); ++n) {
        const auto i = static_cast<std::size_t>(g.node(p, n));
        const double mass = g.sheet.material.excess_mass * g.sheet.area[n];
        sum += 0.5 * mass * cloth.velocity[i].squaredNorm();
      }
    }
  return sum;
}

template double energy<2>(const Cloth<2>&);
template double energy<3>(const Cloth<3>&);

}  // namespace washtub
