#pragma once
#include <vector>

#include "contact/filter.hpp"
#include "contact/held_pairs.hpp"
#include "contact/settings.hpp"

namespace washtub {

/// Coefficients of friction between the groups of a cloth, [group][group]: the geometric mean of
/// their own.
template <int D>
std::vector<std::vector<double>> friction_of_groups(const Cloth<D>& cloth);

/// Keeps cloth from coming nearer to cloth than a gap and from passing through it. Needs a start
/// free of crossings. The repulsion that acts before that is a force of its own (Repulsion).
template <int D>
class Contact {
 public:
  struct Report {
    int held = 0;  ///< pairs held apart
    int cut = 0;   ///< pieces that went a part of their way only
  };

  Contact(const ClothSurface<D>& surface, const Cloth<D>& cloth, const Mesh<D>& mesh,
          const Parallel& parallel, const ContactSettings& settings);

  /// A step begins.
  void start() { held_.start(); }
  /// As HeldPairs::hold (collective).
  void hold(HeldStep<D>& step);
  /// As CrossingFilter::cut (collective).
  Report end(const std::vector<Vec<D>>& X, std::vector<Vec<D>>& Y);

 private:
  const ClothSurface<D>& surface_;
  double gap_;
  PairList<D> list_;
  HeldPairs<D> held_;
  CrossingFilter<D> filter_;
  std::vector<Vec<D>> from_, to_;  ///< places of the points [m]
};

}  // namespace washtub
