#pragma once
#include <optional>
#include <vector>

#include "cloth/cloth.hpp"
#include "solid/mapping.hpp"

namespace washtub {

/// Keeps cloth out of solids and inside the box: no node comes nearer to a surface than half a
/// cell, and of what it is farther away than that it loses at most 1 - exp(-dt/soft) in a step, as
/// lubrication would let it. A node that starts nearer may stay there, but not go deeper. Left
/// alone are pinned nodes, which may even be inside a solid, and nodes of the same piece that start
/// nearer than half a cell to a surface and within three cells of a pinned one, so that cloth may
/// be clamped to a solid.
template <int D>
class Barrier {
 public:
  /// @param soft  time constant of the approach [s]; 0: nodes stop at once at half a cell
  Barrier(const Grid<D>& grid, const DomainMapping<D>& mapping, const Cloth<D>& cloth,
          double soft = 0);

  void state(Archive& archive) {
    archive.same_length("kept", kept_);
    archive.same_length("clearance", clearance_);
    archive.same_length("alone", alone_);
    archive.same_length("accepted", accepted_);
    if (archive.reading()) first_depth_.reset();
  }

  /// A solid by its number, or a side of the box, below 0.
  using Surface = int;

  /// A node that is too near a surface.
  struct Touch {
    int node;
    Surface surface;
    double excess;  ///< by how much [m]
    Vec<D> normal;  ///< unit vector into the surface's body
  };
  /// Nodes that would be too near at X, a step of length dt after the last call of accept(), with
  /// the solids where they are now.
  const std::vector<Touch>& find(const std::vector<Vec<D>>& X, double dt);
  /// The same of one node and surface: by how much it is too near at x, or below 0, is not.
  Touch look(int node, Surface surface, const Vec<D>& x, double dt) const;
  /// Whether a node was so near to a surface at the last accept() that it rubs against it: beyond a
  /// tenth of its margin there is water between.
  bool rubs(int node, const Vec<D>& normal) const {
    return kept_[static_cast<std::size_t>(node)] < 1.1 * margin(normal);
  }
  /// Half a cell, measured along the normal [m].
  double margin(const Vec<D>& normal) const;
  /// Way in the step of the surface's matter that was at x when it began [m].
  Vec<D> way(Surface surface, const Vec<D>& x, double dt) const;

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
  struct Near {
    double psi;  ///< [m], negative in the water
    Vec<D> normal;
    Surface surface;
  };
  /// Calls visit(near) for each surface nearer than the widest cell edge; returns how far the
  /// point may go before another comes within half of that.
  template <class Visit>
  double for_near(const Vec<D>& x, Visit&& visit) const;
  void free_clamps(const Cloth<D>& cloth);
  Near look(Surface surface, const Vec<D>& x) const;
  double distance_kept(int node, const Vec<D>& normal, double dt) const;
  bool project(Vec<D>& x, int node, double& depth) const;
  void find_place(Vec<D>& x, std::size_t node, Report& report);
  double travel(const Vec<D>& moved, double dt) const;

  const Grid<D>& grid_;
  const DomainMapping<D>& mapping_;
  double widest_;  ///< half the largest spacing [m]
  double soft_;
  double fastest_ = 0;             ///< bound of the speed of any solid's matter in the box [m/s]
  std::vector<double> kept_;       ///< distance to the nearest surface at last [m]
  std::vector<double> clearance_;  ///< distance to go before a node has to be looked at again [m]
  std::vector<char> alone_;        ///< nodes left alone
  std::vector<Vec<D>> accepted_;
  std::vector<Touch> touches_;
  std::optional<double> first_depth_;  ///< of this step's first find() [m]
};

}  // namespace washtub
