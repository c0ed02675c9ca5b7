#include "cloth/worst_edge.hpp"

#include <algorithm>
#include <cmath>

#include "cloth/elastic.hpp"

namespace washtub {

double elongation(double E) { return std::sqrt(std::max(0.0, 1 + 2 * E)) - 1; }
double WorstEdge::elongation() const { return washtub::elongation(strain); }

template <int D>
WorstEdge worst_edge(const Cloth<D>& cloth) {
  WorstEdge worst;
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const double* X = cloth.piece(g, p).front().data();
      const auto look = [&](const auto& edges) {
        for (const auto& e : edges) {
          double E = 0;
          elastic::Legs<D, 1, 1>(e, X).strain(e, &E);
          const int node = e.leg[0][0], row = g.sheet.extent[0];
          if (std::abs(E) > std::abs(worst.strain))
            worst = {E, g.first_piece + p, {node % row, node / row}};
        }
      };
      look(g.sheet.inner.edges);
      look(g.sheet.seam.edges);
    }
  return worst;
}

template WorstEdge worst_edge(const Cloth<2>&);
template WorstEdge worst_edge(const Cloth<3>&);

}  // namespace washtub
