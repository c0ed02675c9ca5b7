#pragma once
#include <vector>

#include "base/parallel.hpp"
#include "cloth/surface.hpp"
#include "contact/pair.hpp"
#include "grid/mesh.hpp"

namespace washtub {

/// The largest way of any of the points from x to y [m].
template <int D>
double farthest(const std::vector<Vec<D>>& x, const std::vector<Vec<D>>& y);

/// Of a number of pieces, those that one of several ranks looks after.
struct Share {
  int rank = 0, ranks = 1;

  Share() = default;
  explicit Share(const Parallel& parallel) : rank(parallel.rank()), ranks(parallel.size()) {}
  bool has(int piece) const { return piece % ranks == rank; }
};

/// Parts of the cloth without a common node that are near each other: all that can come within a
/// distance. Each rank lists those of its own share of pieces. The list is kept until points have
/// moved so far that others may matter.
template <int D>
class PairList {
 public:
  /// @param skin  by how much farther than asked for a list reaches [m]
  PairList(const ClothSurface<D>& surface, const Mesh<D>& mesh, double skin, Share share = {})
      : surface_(surface), mesh_(mesh), skin_(skin), share_(share) {}

  /// On return pairs() has all pairs that can come within `least` [m] while the points move
  /// straight from x to y.
  void cover(const std::vector<Vec<D>>& x, const std::vector<Vec<D>>& y, double least);
  const std::vector<Pair<D>>& pairs() const { return pairs_; }
  /// Calls visit(pair) for those that may come within `least` [m] on that way.
  template <class Visit>
  void for_near(double least, Visit&& visit) const {
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      if (distance_[k] - slack_ <= least) visit(pairs_[k]);
  }
  /// Calls visit(pair) for those that may come to within `part` of their distance on that way.
  template <class Visit>
  void for_closing(double part, Visit&& visit) const {
    for (std::size_t k = 0; k < pairs_.size(); ++k)
      if (distance_[k] - slack_ <= part * (distance_[k] + slack_)) visit(pairs_[k]);
  }

 private:
  void list(const std::vector<Vec<D>>& x);
  void list_nodes(const std::vector<Vec<D>>& x);
  void list_edges(const std::vector<Vec<D>>& x);
  void add(const Pair<D>& pair, const std::vector<Vec<D>>& x);
  bool mine(int point) const;
  bool joined(int a, int b) const;

  const ClothSurface<D>& surface_;
  Mesh<D> mesh_;
  double skin_;
  Share share_;
  double reach_ = 0;           ///< distance up to which pairs were listed [m]
  double slack_ = 0;           ///< by how much distances may have changed since, or will [m]
  std::vector<Vec<D>> where_;  ///< the points were then [m]
  std::vector<Pair<D>> pairs_;
  std::vector<double> distance_;  ///< of each when it was listed [m]
};

}  // namespace washtub
