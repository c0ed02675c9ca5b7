#pragma once
#include <vector>

#include "contact/held_step.hpp"
#include "contact/pair_list.hpp"

namespace washtub {

/// Holds parts of the cloth apart that would come nearer than a gap within an implicit step.
///
/// A pair whose straight way would bring it nearer gets, with the normal and weights it has then, a
/// force lambda >= 0 along that normal, and against sliding one of at most `friction` lambda. All
/// of them are found by sweeps of projected Gauss-Seidel in the metric of the nodes' inertia
/// (Jourdan, Alart & Jean 1998); the pieces concerned are then solved again with them. A pair that
/// starts nearer than the gap has to widen, so that gaps do not dwindle from step to step.
template <int D>
class HeldPairs {
 public:
  /// @param gap       that pairs keep [m]
  /// @param friction  coefficient between points of the surface's groups, [group][group]
  HeldPairs(const ClothSurface<D>& surface, const Parallel& parallel, double gap,
            std::vector<std::vector<double>> friction)
      : surface_(surface), parallel_(parallel), gap_(gap), friction_(std::move(friction)) {}

  /// Forgets the pairs of the step before.
  void start() { held_.clear(); }
  /// Looks at the way from `start` to `next`; on return step.push has changed, and the nodes are
  /// marked, unless all pairs are far enough apart (collective).
  /// @param list  covers that way for the gap
  /// @param from  places of the surface's points at `start` and
  /// @param to    at `next` [m]
  void hold(const PairList<D>& list, const std::vector<Vec<D>>& from, const std::vector<Vec<D>>& to,
            HeldStep<D>& step);
  int count() const { return static_cast<int>(held_.size()); }

 private:
  struct Held {
    Pair<D> pair;
    typename Pair<D>::Weights weight;
    Vec<D> normal;
    double least;   ///< gap . normal at the end of the step [m]
    double force;   ///< lambda [N]
    Vec<D> drag;    ///< friction on the first part [N]
    Vec<D> change;  ///< of the whole force in this call [N]
  };

  void look(const Pair<D>& pair, const std::vector<Vec<D>>& x, const std::vector<Vec<D>>& y);
  void gather();
  void sweep(Held& held, const HeldStep<D>& step, double& worst);
  Mat<D> yielding(const Held& held, const HeldStep<D>& step) const;
  double friction(const Pair<D>& pair) const;
  Vec<D> gap(const Held& held, const std::vector<Vec<D>>& x) const;

  const ClothSurface<D>& surface_;
  Parallel parallel_;
  double gap_;
  std::vector<std::vector<double>> friction_;
  std::vector<Held> held_, found_, before_;
  std::vector<Vec<D>> moved_;  ///< `next` with the response to the forces of this call [m]
};

}  // namespace washtub
