#include "contact/pair_list.hpp"

#include <algorithm>
#include <cmath>

#include "cloth/boxes.hpp"

namespace washtub {
namespace {

template <int D, std::size_t N>
BoundingBox<D> box_of(const std::array<int, N>& points, const std::vector<Vec<D>>& x, double by) {
  std::array<Vec<D>, N> corners;
  for (std::size_t n = 0; n < N; ++n) corners[n] = x[static_cast<std::size_t>(points[n])];
  BoundingBox<D> box = box_about<D>(corners);
  box.lower.array() -= by;
  box.upper.array() += by;
  return box;
}

template <int D>
double longest_edge(const std::vector<BoundingBox<D>>& boxes) {
  double longest = 0;
  for (const auto& box : boxes) longest = std::max(longest, box.size().maxCoeff());
  return longest;
}

}  // namespace

template <int D>
double farthest(const std::vector<Vec<D>>& x, const std::vector<Vec<D>>& y) {
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i)
    squares = std::max(squares, (y[i] - x[i]).squaredNorm());
  return std::sqrt(squares);
}

template <int D>
void PairList<D>::cover(const std::vector<Vec<D>>& x, const std::vector<Vec<D>>& y, double least) {
  if (where_.size() == x.size()) {
    slack_ = 2 * std::max(farthest<D>(where_, x), farthest<D>(where_, y));
    if (least + slack_ <= reach_) return;
  }
  slack_ = 2 * farthest<D>(x, y);
  reach_ = least + slack_ + skin_;
  list(x);
}

template <int D>
void PairList<D>::list(const std::vector<Vec<D>>& x) {
  where_ = x;
  pairs_.clear();
  distance_.clear();
  list_nodes(x);
  if constexpr (D == 3) list_edges(x);
}

template <int D>
bool PairList<D>::mine(int point) const {
  return share_.has(surface_.piece[static_cast<std::size_t>(point)]);
}

template <int D>
bool PairList<D>::joined(int a, int b) const {
  return surface_.node[static_cast<std::size_t>(a)] == surface_.node[static_cast<std::size_t>(b)];
}

template <int D>
void PairList<D>::add(const Pair<D>& pair, const std::vector<Vec<D>>& x) {
  for (int a = 0; a < pair.split; ++a)
    for (std::size_t b = static_cast<std::size_t>(pair.split); b < Pair<D>::points; ++b)
      if (joined(pair.point[static_cast<std::size_t>(a)], pair.point[b])) return;
  const double d = nearest<D>(pair.split, pair.places(x)).gap.norm();
  if (d >= reach_) return;
  pairs_.push_back(pair);
  distance_.push_back(d);
}

template <int D>
void PairList<D>::list_nodes(const std::vector<Vec<D>>& x) {
  std::vector<BoundingBox<D>> boxes;
  for (const auto& face : surface_.faces) boxes.push_back(box_of<D>(face, x, 0));
  const BoxLists<D> near(boxes, mesh_, 2 * reach_);
  for (int i = 0; i < surface_.points(); ++i) {
    if (surface_.node[static_cast<std::size_t>(i)] != i || !mine(i)) continue;
    near.for_overlaps(box_of<D>(std::array{i}, x, reach_), [&](std::size_t f, const Vec<D>& shift) {
      Pair<D> pair{{i}, 1, shift};
      std::copy(surface_.faces[f].begin(), surface_.faces[f].end(), pair.point.begin() + 1);
      add(pair, x);
    });
  }
}

template <int D>
void PairList<D>::list_edges(const std::vector<Vec<D>>& x) {
  std::vector<BoundingBox<D>> boxes;
  for (const auto& edge : surface_.edges) boxes.push_back(box_of<D>(edge, x, 0));
  const BoxLists<D> near(boxes, mesh_, longest_edge(boxes) + 2 * reach_);
  for (std::size_t e = 0; e < surface_.edges.size(); ++e) {
    const auto& a = surface_.edges[e];
    if (!mine(a[0])) continue;
    near.for_overlaps(box_of<D>(a, x, reach_), [&](std::size_t f, const Vec<D>& shift) {
      const auto& b = surface_.edges[f];
      if (f <= e) return;  // each pair once
      if constexpr (D == 3) add({{a[0], a[1], b[0], b[1]}, 2, shift}, x);
    });
  }
}

template double farthest<2>(const std::vector<Vec<2>>&, const std::vector<Vec<2>>&);
template double farthest<3>(const std::vector<Vec<3>>&, const std::vector<Vec<3>>&);
template class PairList<2>;
template class PairList<3>;

}  // namespace washtub
