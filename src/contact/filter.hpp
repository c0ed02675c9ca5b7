#pragma once
#include "contact/pair_list.hpp"

namespace washtub {

/// The guarantee that cloth does not pass through cloth. A piece in a pair that would lose most of
/// its distance on the straight way from X to Y goes only a part of its way; in the end, none.
template <int D>
class CrossingFilter {
 public:
  CrossingFilter(const ClothSurface<D>& surface, const Parallel& parallel)
      : surface_(surface), parallel_(parallel) {}

  /// On return no face is passed through on the way from X to Y, provided that none is at X
  /// (collective). Returns the number of pieces that were cut short.
  /// @param list  covers the way from X to Y for a distance of 0
  int cut(PairList<D>& list, const std::vector<Vec<D>>& X, std::vector<Vec<D>>& Y);
  /// The shortest part of its way that a piece went in the last call [1].
  double shortest() const { return shortest_; }

 private:
  bool look(const Pair<D>& pair, bool stop);
  bool find_factors(const PairList<D>& list, bool stop);

  const ClothSurface<D>& surface_;
  Parallel parallel_;
  double shortest_ = 1;
  std::vector<Vec<D>> from_, to_, whole_;
  std::vector<double> factor_, fraction_;  ///< of each piece
};

}  // namespace washtub
