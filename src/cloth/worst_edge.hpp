#pragma once
#include "cloth/cloth.hpp"

namespace washtub {

/// The edge between two nodes whose length is furthest from that at rest.
struct WorstEdge {
  double strain = 0;  ///< Green's strain E = (l^2/l_0^2 - 1)/2 [1]; below 0 where it is shortened
  int piece = 0;      ///< among all pieces, from 0
  std::array<int, 2> node{};  ///< (i, j) along r and s from which the edge starts, from 0

  double elongation() const;  ///< l/l_0 - 1 [1]
};

/// Over all edges of all pieces where they are now; E = 0 where there is no cloth.
template <int D>
WorstEdge worst_edge(const Cloth<D>& cloth);

/// l/l_0 - 1 of an edge whose Green's strain is E >= -1/2.
double elongation(double E);

}  // namespace washtub
