#pragma once
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"

namespace washtub {

/// A box along the axes [m].
template <int D>
struct BoundingBox {
  Vec<D> lower, upper;
  Vec<D> middle() const { return 0.5 * (lower + upper); }
  Vec<D> size() const { return upper - lower; }
};

/// The least box with all of some points in it.
template <int D, class Points>
BoundingBox<D> box_about(const Points& points) {
  BoundingBox<D> b{points[0], points[0]};
  for (const Vec<D>& p : points) b.lower = b.lower.cwiseMin(p), b.upper = b.upper.cwiseMax(p);
  return b;
}

/// Boxes sorted into the bins of a regular lattice by their middles, so that those which overlap
/// with another one are found among few.
template <int D>
class BoxLists {
 public:
  /// `longest`: the longest edge [m] of any box that will be asked for. Periodic sides of `mesh`
  /// let boxes meet images beyond them.
  BoxLists(const std::vector<BoundingBox<D>>& boxes, const Mesh<D>& mesh, double longest);

  /// Calls visit(number, shift) for each box that overlaps with `box` moved by `shift`, which leads
  /// to its nearest image.
  template <class Visit>
  void for_overlaps(const BoundingBox<D>& box, Visit&& visit) const;

 private:
  Index<D> bin(const Vec<D>& x) const;
  long number(const Index<D>& bin) const;
  Mesh<D> mesh_;
  std::vector<BoundingBox<D>> boxes_;  ///< sorted by bin
  std::vector<std::size_t> original_;  ///< their numbers as given
  std::vector<std::size_t> first_;     ///< of each bin, and the end of the last
  Vec<D> lower_, period_;              ///< period: 0 where there is none
  Vec<D> width_;                       ///< of a bin
  Index<D> bins_;
};

template <int D>
template <class Visit>
void BoxLists<D>::for_overlaps(const BoundingBox<D>& box, Visit&& visit) const {
  const Vec<D> middle = box.middle(), half = 0.5 * box.size();
  const auto look_at = [&](const Index<D>& b) {
    const auto n = static_cast<std::size_t>(number(b));
    for (std::size_t i = first_[n]; i < first_[n + 1]; ++i) {
      const Vec<D> way = boxes_[i].middle() - middle, shift = mesh_.periods_in(way);
      const Vec<D> apart = (way - shift).cwiseAbs() - half - 0.5 * boxes_[i].size();
      if (apart.maxCoeff() <= 0) visit(original_[i], shift);
    }
  };
  const Index<D> centre = bin(middle);
  Index<D> low, high;
  for (int d = 0; d < D; ++d) {
    const bool few = bins_[d] < 3;  // then all of them are neighbours
    low[d] = few ? 0 : period_[d] > 0 ? centre[d] - 1 : std::max(centre[d] - 1, 0);
    high[d] = few              ? bins_[d] - 1
              : period_[d] > 0 ? centre[d] + 1
                               : std::min(centre[d] + 1, bins_[d] - 1);
  }
  Index<D> at = low;
  for (int d = 0; d < D;) {
    Index<D> b = at;
    for (int e = 0; e < D; ++e) b[e] = (at[e] + bins_[e]) % bins_[e];
    look_at(b);
    for (d = 0; d < D && ++at[d] > high[d]; ++d) at[d] = low[d];
  }
}

}  // namespace washtub
