#include "coupling/markers.hpp"

#include <cmath>

namespace washtub {
namespace {

/// Markers along one direction of a sheet: the interval each lies in, and its place in it.
struct Line {
  int refine, nodes;
  bool closed;

  int count() const {
    if (nodes == 1) return 1;
    return closed ? nodes * refine : (nodes - 1) * refine + 1;
  }
  /// Beyond the last node where the marker lies across the seam.
  int node(int m, int end) const {
    if (closed) return m / refine + end;
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
    if (closed) return refine;
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
      line[d] = {std::max(1, static_cast<int>(std::ceil(ds / spacing - 1e-9))), g.sheet.extent[d],
                 g.sheet.closed[d]};
    }
    for (int p = 0; p < g.pieces; ++p)
      for (int b = 0; b < line[1].count(); ++b)
        for (int a = 0; a < line[0].count(); ++a) {
          auto& node = node_.emplace_back();
          auto& shape = shape_.emplace_back();
          auto& share = share_.emplace_back();
          Vec<D>& shift = shift_.emplace_back(Vec<D>::Zero());
          for (int c = 0; c < corners; ++c) {
            const int er = D == 3 ? c % 2 : 0, es = D == 3 ? c / 2 : c;
            const int i = line[0].node(a, er), j = line[1].node(b, es);
            const Image<D> image = g.sheet.image(i, j);
            node[c] = g.node(p, image.node);
            shape[c] = line[0].shape(a, er) * line[1].shape(b, es);
            shift += shape[c] * image.shift;
            share[c] = shape[c] / (line[0].weight(i) * line[1].weight(j));
          }
        }
  }
}

template class Markers<2>;
template class Markers<3>;

}  // namespace washtub
