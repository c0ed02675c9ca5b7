#pragma once
#include <vector>

#include "contact/barrier.hpp"
#include "contact/held_step.hpp"

namespace washtub {

/// Holds nodes off surfaces within an implicit step, as the Barrier asks for, and lets them slide
/// under Coulomb friction. A node that touches is bound to a plane by a stiff spring, that pulls no
/// node back. A node that sticks is bound to the place of the surface's matter where it came to
/// rest, its anchor, which is kept from step to step: it does not creep.
template <int D>
class SolidHold {
 public:
  /// @param friction  coefficient of each node against any surface
  SolidHold(Barrier<D>& barrier, std::vector<double> friction)
      : barrier_(barrier), friction_(std::move(friction)) {}

  /// Takes up the touches of the step before, and forgets what came of them.
  void start();
  /// Looks at where the nodes are; marks those whose hold has changed.
  void hold(HeldStep<D>& step);
  /// Adds what holds a node to its stiffness [N/m], and what pulls at it there [N].
  void add(int node, Mat<D>& stiffness, Vec<D>& pull) const;
  /// The step ends at Y: finds the forces of the surfaces on their nodes, and notes the anchors.
  void end(const std::vector<Vec<D>>& Y);

  /// Calls visit(node, surface, force) for each touch of the last step [N].
  template <class Visit>
  void for_forces(Visit&& visit) const {
    for (const Touch& t : touches_) visit(t.node, t.surface, t.force);
  }
  int count() const { return static_cast<int>(touches_.size()); }
  /// Touches by number (of the node's), so that each rank finds the same.
  void state(Archive& archive);

 private:
  using Surface = typename Barrier<D>::Surface;
  struct Touch {
    int node;
    Surface surface;
    Vec<D> normal;
    double plane = 0;  ///< normal . x that the node must not exceed [m]
    double spring = 0;
    bool sticks = false;
    Vec<D> anchor = Vec<D>::Zero();  ///< [m]
    Vec<D> drag = Vec<D>::Zero();    ///< of sliding [N]
    Vec<D> force = Vec<D>::Zero();   ///< of the surface on the node [N]

    double pressing(const Vec<D>& x) const { return spring * (normal.dot(x) - plane); }
    Vec<D> aside(const Vec<D>& x) const {
      const Vec<D> way = x - anchor;
      return way - way.dot(normal) * normal;
    }
  };
  /// What is left of a touch for the next step.
  struct Anchor {
    int node;
    Surface surface;
    Vec<D> place;  ///< [m]
    Vec<D> drag;   ///< 0 if it sticks [N]
  };

  void begin(const typename Barrier<D>::Touch& found, HeldStep<D>& step);
  bool follow(Touch& touch, HeldStep<D>& step);
  bool rub(Touch& touch, const Vec<D>& x) const;
  const Anchor* anchor(int node, Surface surface) const;

  Barrier<D>& barrier_;
  std::vector<double> friction_;
  std::vector<Touch> touches_;  ///< by node
  std::vector<Anchor> anchors_;
};

}  // namespace washtub
