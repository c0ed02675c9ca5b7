#include "coupling/markers.hpp"

#include <cmath>

namespace washtub {
namespace {

/// Markers along one direction of a sheet: the interval each lies in, and its place in it.
struct Line {
  int refine, nodes;

  int count() const { return nodes == 1 ? 1 : (nodes - 1) * refine + 1; }
  int node(int m, int end) const {
    const int i = std::min(m / refine, std::max(nodes - 2, 0));
    return std::min(i + end, nodes - 1);
  }
  double shape(int m, int end) const {
    if (nodes == 1) return end == 0 ? 1 : 0;
    const double x = static_cast<double>(m) / refine - node(m, 0);
    return end == 0 ? 1 - x : x;
  }
  /// Sum of a node's hat function over its markers.
  double weight(int i) const {
    if (nodes == 1) return 1;
    return i == 0 || i == nodes - 1 ? 0.5 * (refine + 1) : refine;
  }
};

}  // namespace

template <int D>
Markers<D>::Markers(const Cloth<D>& cloth, double spacing) {
  for (const auto& g : cloth.groups) {
    std::array<Line, 2> line;
    for (int d = 0; d < 2; ++d) {
      const double ds = g.sheet.extent[d] > 1 ? g.sheet.spacing[d] : 0;
      line[d] = {std::max(1, static_cast<int>(std::ceil(ds / spacing - 1e-9))), g.sheet.extent[d]};
    }
    for (int p = 0; p < g.pieces; ++p)
      for (int b = 0; b < line[1].count(); ++b)
        for (int a = 0; a < line[0].count(); ++a) {
          auto& node = node_.emplace_back();
          auto& shape = shape_.emplace_back();
          auto& share = share_.emplace_back();
          for (int c = 0; c < corners; ++c) {
            const int er = D == 3 ? c % 2 : 0, es = D == 3 ? c / 2 : c;
            const int i = line[0].node(a, er), j = line[1].node(b, es);
            node[c] = g.node(p, g.sheet.node(i, j));
            shape[c] = line[0].shape(a, er) * line[1].shape(b, es);
            share[c] = shape[c] / (line[0].weight(i) * line[1].weight(j));
          }
        }
  }
}

template class Markers<2>;
template class Markers<3>;

}  // namespace washtub
