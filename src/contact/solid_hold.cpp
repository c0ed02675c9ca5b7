#include "contact/solid_hold.hpp"

#include <algorithm>

namespace washtub {
namespace {

constexpr double grip = 1e4;      // stiffness of a held node over that of a free one
constexpr double close = 1e-2;    // of the distance asked for: a held node is where it should be
constexpr double settled = 0.05;  // of the friction, by which it may still change

}  // namespace

template <int D>
auto SolidHold<D>::anchor(int node, Surface surface) const -> const Anchor* {
  const auto found = std::find_if(anchors_.begin(), anchors_.end(), [&](const Anchor& a) {
    return a.node == node && a.surface == surface;
  });
  return found == anchors_.end() ? nullptr : &*found;
}

template <int D>
void SolidHold<D>::start() {
  touches_.clear();
}

/// A node that was not held by that surface.
template <int D>
void SolidHold<D>::begin(const typename Barrier<D>::Touch& found, HeldStep<D>& step) {
  const auto i = static_cast<std::size_t>(found.node);
  Touch t{found.node, found.surface, found.normal};
  t.plane = t.normal.dot(step.next[i]) - found.excess;
  t.spring = grip / step.yield[i].diagonal().minCoeff();
  const Anchor* before = anchor(t.node, t.surface);
  t.anchor = before ? before->place : step.start[i];
  t.anchor += barrier_.way(t.surface, t.anchor, step.dt);
  if (friction_[i] > 0 && barrier_.rubs(t.node, t.normal)) {
    t.sticks = !before || before->drag.isZero(0);
    if (!t.sticks) t.drag = before->drag;
  }
  step.pushed[i] = 1;
  const auto after = std::find_if(touches_.begin(), touches_.end(),
                                  [&](const Touch& o) { return o.node > t.node; });
  touches_.insert(after, t);
}

/// Whether a node sticks or slides, and what friction it has then; true if that has changed.
template <int D>
bool SolidHold<D>::rub(Touch& t, const Vec<D>& x) const {
  if (!barrier_.rubs(t.node, t.normal)) return false;
  const double most = friction_[static_cast<std::size_t>(t.node)] * t.pressing(x);
  if (!(most > 0)) return false;
  const Vec<D> way = t.aside(x);
  const double length = way.norm();
  if (t.sticks) {
    if (t.spring * length <= most) return false;
    t.sticks = false;
    t.drag = -most / length * way;
    return true;
  }
  if (way.dot(t.drag) > 0) {  // pushed along by its own friction
    t.sticks = true;
    t.drag.setZero();
    return true;
  }
  const Vec<D> before = t.drag;
  if (length > 0) t.drag = -most / length * way;
  return (t.drag - before).norm() > settled * before.norm();
}

/// Adapts a touch to where the node is; false if it does not touch any more.
template <int D>
bool SolidHold<D>::follow(Touch& t, HeldStep<D>& step) {
  const auto i = static_cast<std::size_t>(t.node);
  const Vec<D>& x = step.next[i];
  if (t.pressing(x) < 0) {
    step.pushed[i] = 1;
    return false;
  }
  const auto now = barrier_.look(t.node, t.surface, x, step.dt);
  const double tolerance = close * barrier_.margin(now.normal);
  bool changed = rub(t, x);
  if (std::abs(now.excess) > tolerance) {
    t.normal = now.normal;
    t.plane = t.normal.dot(x) - now.excess;
    changed = true;
  }
  if (changed) step.pushed[i] = 1;
  return true;
}

template <int D>
void SolidHold<D>::hold(HeldStep<D>& step) {
  std::erase_if(touches_, [&](Touch& t) { return !follow(t, step); });
  for (const auto& found : barrier_.find(step.next, step.dt)) {
    const bool known = std::any_of(touches_.begin(), touches_.end(), [&](const Touch& t) {
      return t.node == found.node && t.surface == found.surface;
    });
    if (!known) begin(found, step);
  }
}

template <int D>
void SolidHold<D>::add(int node, Mat<D>& stiffness, Vec<D>& pull) const {
  for (const Touch& t : touches_) {
    if (t.node != node) continue;
    const Mat<D> along = t.normal * t.normal.transpose();
    stiffness += t.spring * along;
    pull += t.spring * t.plane * t.normal + t.drag;
    if (!t.sticks) continue;
    const Mat<D> aside = Mat<D>::Identity() - along;
    stiffness += t.spring * aside;
    pull += t.spring * (aside * t.anchor);
  }
}

template <int D>
void SolidHold<D>::end(const std::vector<Vec<D>>& Y) {
  anchors_.clear();
  for (Touch& t : touches_) {
    const Vec<D>& y = Y[static_cast<std::size_t>(t.node)];
    t.force = t.drag - t.pressing(y) * t.normal;
    if (t.sticks) t.force -= t.spring * t.aside(y);
    anchors_.push_back({t.node, t.surface, t.sticks ? t.anchor : y, t.drag});
  }
}

template <int D>
void SolidHold<D>::state(Archive& archive) {
  std::vector<int> node, surface;
  std::vector<Vec<D>> place, drag;
  for (const Anchor& a : anchors_) {
    node.push_back(a.node);
    surface.push_back(a.surface);
    place.push_back(a.place);
    drag.push_back(a.drag);
  }
  archive.value("node", node);
  archive.value("surface", surface);
  archive.value("place", place);
  archive.value("drag", drag);
  if (!archive.reading()) return;
  anchors_.clear();
  for (std::size_t k = 0; k < node.size(); ++k)
    anchors_.push_back({node[k], surface[k], place[k], drag[k]});
  touches_.clear();
}

template class SolidHold<2>;
template class SolidHold<3>;

}  // namespace washtub
