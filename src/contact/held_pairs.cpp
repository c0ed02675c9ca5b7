#include "contact/held_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

constexpr int sweeps = 8;        // over the held pairs, in a call
constexpr double recover = 0.1;  // of the gap, by which pairs that are nearer widen in a step
constexpr double enough = 0.05;  // of the gap: a miss below that is left
constexpr double fine = 1e-3;    // likewise, within the sweeps

}  // namespace

template <int D>
double HeldPairs<D>::friction(const Pair<D>& pair) const {
  const auto group = [&](int point) {
    const int piece = surface_.piece[static_cast<std::size_t>(point)];
    return static_cast<std::size_t>(surface_.group[static_cast<std::size_t>(piece)]);
  };
  return friction_[group(pair.point.front())][group(pair.point.back())];
}

/// Notes a pair that would come too near on its way from x to y.
template <int D>
void HeldPairs<D>::look(const Pair<D>& pair, const std::vector<Vec<D>>& x,
                        const std::vector<Vec<D>>& y) {
  const auto at = pair.places(x);
  auto way = pair.places(y);
  for (std::size_t k = 0; k < at.size(); ++k) way[k] -= at[k];
  const double d = nearest<D>(pair.split, at).gap.norm();
  const double least = std::min(gap_, d + recover * gap_);
  if (!(d > 0) || d - closing<D>(pair.split, way) > least) return;
  if (std::any_of(held_.begin(), held_.end(), [&](const Held& h) { return h.pair == pair; }))
    return;
  const auto impact = find_impact<D>(pair.split, at, way, least);
  if (!impact) return;
  found_.push_back(
      {pair, impact->weight, impact->normal, least, 0, Vec<D>::Zero(), Vec<D>::Zero()});
}

/// The pairs that any rank found, in an order that does not depend on the ranks, are held.
template <int D>
void HeldPairs<D>::gather() {
  if (parallel_.size() > 1) parallel_.gather(found_);
  std::sort(found_.begin(), found_.end(),
            [](const Held& a, const Held& b) { return a.pair < b.pair; });
  held_.insert(held_.end(), found_.begin(), found_.end());
}

/// The gap of a pair with the weights with which it is held [m].
template <int D>
Vec<D> HeldPairs<D>::gap(const Held& held, const std::vector<Vec<D>>& x) const {
  Vec<D> sum = held.pair.shift;  // the weights of the first part add up to one
  for (std::size_t k = 0; k < Pair<D>::points; ++k) {
    const auto point = static_cast<std::size_t>(held.pair.point[k]);
    sum += held.weight[k] *
           (x[static_cast<std::size_t>(surface_.node[point])] + surface_.shift[point]);
  }
  return sum;
}

/// What the gap of a pair gives way to a unit of force [m/N].
template <int D>
Mat<D> HeldPairs<D>::yielding(const Held& held, const HeldStep<D>& step) const {
  Mat<D> sum = Mat<D>::Zero();
  for (std::size_t k = 0; k < Pair<D>::points; ++k) {
    const auto node =
        static_cast<std::size_t>(surface_.node[static_cast<std::size_t>(held.pair.point[k])]);
    sum += held.weight[k] * held.weight[k] * step.yield[node];
  }
  return sum;
}

/// Betters the force of one pair. `worst` grows to what its distance lacked before [m].
template <int D>
void HeldPairs<D>::sweep(Held& held, const HeldStep<D>& step, double& worst) {
  const Vec<D>& n = held.normal;
  const Mat<D> yields = yielding(held, step);
  const Vec<D> now = gap(held, moved_);
  const double miss = held.least - now.dot(n);
  worst = std::max(worst, miss);
  if (held.force == 0 && miss <= fine * gap_) return;
  const double along = n.dot(yields * n);
  const double force = std::max(0.0, held.force + miss / along);
  Vec<D> drag = Vec<D>::Zero();
  if (const double most = friction(held.pair) * force; most > 0) {
    const Vec<D> slid = now - gap(held, step.start), aside = slid - slid.dot(n) * n;
    drag = held.drag - aside * (D - 1) / (yields.trace() - along);
    if (drag.norm() > most) drag *= most / drag.norm();
  }
  const Vec<D> change = (force - held.force) * n + drag - held.drag;
  held.force = force;
  held.drag = drag;
  held.change += change;
  for (std::size_t k = 0; k < Pair<D>::points; ++k) {
    const auto node =
        static_cast<std::size_t>(surface_.node[static_cast<std::size_t>(held.pair.point[k])]);
    moved_[node] += held.weight[k] * (step.yield[node] * change);
  }
}

template <int D>
void HeldPairs<D>::hold(const PairList<D>& list, const std::vector<Vec<D>>& from,
                        const std::vector<Vec<D>>& to, HeldStep<D>& step) {
  found_.clear();
  list.for_near(gap_, [&](const Pair<D>& pair) { look(pair, from, to); });
  gather();
  if (held_.empty()) return;
  moved_ = step.next;
  before_ = held_;
  for (Held& h : held_) h.change.setZero();
  double worst = 0, later = 0;
  for (int s = 0; s < sweeps; ++s)
    for (Held& h : held_) sweep(h, step, s == 0 ? worst : later);
  if (worst <= enough * gap_) {
    held_.swap(before_);
    return;
  }
  for (const Held& h : held_)
    for (std::size_t k = 0; k < Pair<D>::points; ++k) {
      if (h.change.isZero(0)) continue;
      const auto node =
          static_cast<std::size_t>(surface_.node[static_cast<std::size_t>(h.pair.point[k])]);
      step.push[node] += h.weight[k] * h.change;
      step.pushed[node] = 1;
    }
}

template class HeldPairs<2>;
template class HeldPairs<3>;

}  // namespace washtub
