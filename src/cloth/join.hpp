#pragma once
#include <cmath>
#include <utility>
#include <vector>

#include "cloth/sheet.hpp"

namespace washtub {

/// That of an edge which stands for `area` [m^2] of cloth; in 2-D length [m].
inline Stiffening stiffening(const Material& m, double area) {
  if (!std::isfinite(m.knee)) return {};
  return {m.knee, (m.stretch_beyond - m.stretch) * area};
}

/// The list of strains over N legs.
template <int N, int D, bool seam>
auto& strains(Elements<D, seam>& elements) {
  if constexpr (N == 1)
    return elements.edges;
  else if constexpr (N == 2)
    return elements.shears;
  else
    return elements.dilations;
}

/// Adds W = stiffness E^2/2, E = offset + sum_k weight_k |b_k - a_k|^2 over the legs (a_k, b_k), to
/// the elements across a seam or to the others.
template <int N, int D>
void join_strain(Sheet<D>& sheet, const std::array<std::array<Image<D>, 2>, N>& ends,
                 const std::array<double, N>& weight, double offset, double stiffness,
                 const IfEdge<N, Stiffening>& beyond = {}) {
  Strain<D, N, true> e{{}, weight, offset, stiffness, beyond, {}};
  bool across = false;
  for (int k = 0; k < N; ++k) {
    const auto& [a, b] = ends[k];
    const Vec<D> shift = b.shift - a.shift;
    e.leg[k] = {a.node, b.node};
    for (int c = 0; c < D; ++c) e.shift[k][c] = shift[c];
    across = across || !shift.isZero(0);
  }
  if (across)
    strains<N>(sheet.seam).push_back(e);
  else
    strains<N>(sheet.inner).push_back({e.leg, weight, offset, stiffness, beyond, {}});
}

/// Adds W = stiffness |v|^2/2, where v is the sum of weight times node over the terms.
template <int D>
void join_bend(Sheet<D>& sheet, const std::vector<std::pair<Image<D>, double>>& terms,
               double stiffness) {
  Bend<D, true> e{0, {}, {}, stiffness, {}};
  bool across = false;
  for (const auto& [x, weight] : terms) {
    e.node[e.count] = x.node;
    e.weight[e.count++] = weight;
    for (int c = 0; c < D; ++c) e.shift[c] += weight * x.shift[c];
    across = across || !x.shift.isZero(0);
  }
  if (across)
    sheet.seam.bends.push_back(e);
  else
    sheet.inner.bends.push_back({e.count, e.node, e.weight, stiffness, {}});
}

}  // namespace washtub
