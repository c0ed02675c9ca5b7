#pragma once
#include <optional>
#include <vector>

#include "cloth/cloth.hpp"
#include "solid/mapping.hpp"

namespace washtub {

/// Keeps cloth out of solids and inside the box: no node comes nearer to a surface than half a
/// cell. A node that starts nearer may stay there, but not go deeper. Left alone are pinned nodes,
/// which may even be inside a solid, and nodes of the same piece that start nearer than half a cell
/// to a surface and within three cells of a pinned one, so that cloth may be clamped to a solid.
template <int D>
class Barrier {
 public:
  Barrier(const Grid<D>& grid, const DomainMapping<D>& mapping, const Cloth<D>& cloth);

  void state(Archive& archive) {
    archive.same_length("kept", kept_);
    archive.same_length("clearance", clearance_);
    archive.same_length("alone", alone_);
    archive.same_length("accepted", accepted_);
    if (archive.reading()) first_depth_.reset();
  }

  static constexpr int no_solid = -1;

  /// A node that would come too near.
  struct Contact {
    int node;
    int solid;  ///< which it would touch; no_solid for a side of the box
    Vec<D> to;  ///< the nearest allowed place [m]
  };
  /// Nodes that would be too near at X, a step of length dt after the last call of accept(), with
  /// the solids where they are now.
  const std::vector<Contact>& find(const std::vector<Vec<D>>& X, double dt);

  struct Report {
    int touched = 0;         ///< nodes too near
    double depth = 0;        ///< deepest a node would have gone, had nothing held it off [m]
    double penetration = 0;  ///< deepest a node is inside a solid or beyond a side after all [m]
  };
  /// Takes X as the new state after a step dt. On return no node of X is nearer than allowed. The
  /// depth is that of the first find() since the last call, before any node was held; without one,
  /// that of X as given.
  Report accept(std::vector<Vec<D>>& X, double dt);

  /// The image of x within a periodic box.
  Vec<D> inside(Vec<D> x) const;

 private:
  struct Surface {
    double psi;  ///< [m], negative in the water
    Vec<D> normal;
    int solid;
  };
  /// Calls visit(surface) for each surface nearer than the widest cell edge; returns how far the
  /// point may go before another comes within half of that.
  template <class Visit>
  double for_near(const Vec<D>& x, Visit&& visit) const;
  void free_clamps(const Cloth<D>& cloth);
  double margin(const Vec<D>& normal) const;
  bool project(Vec<D>& x, int node, int& solid, double& depth) const;
  void find_place(Vec<D>& x, std::size_t node, Report& report);
  double travel(const Vec<D>& moved, double dt) const;

  const Grid<D>& grid_;
  const DomainMapping<D>& mapping_;
  double widest_;                  ///< half the largest spacing [m]
  double fastest_ = 0;             ///< bound of the speed of any solid's matter in the box [m/s]
  std::vector<double> kept_;       ///< distance to the nearest surface at last [m]
  std::vector<double> clearance_;  ///< distance to go before a node has to be looked at again [m]
  std::vector<char> alone_;        ///< nodes left alone
  std::vector<Vec<D>> accepted_;
  std::vector<Contact> contacts_;
  std::optional<double> first_depth_;  ///< of this step's first find() [m]
};

}  // namespace washtub
