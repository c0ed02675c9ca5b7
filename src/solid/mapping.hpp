#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "grid/grid.hpp"
#include "grid/held_faces.hpp"
#include "solid/heaviside.hpp"
#include "solid/solid.hpp"
#include "solid/surface_faces.hpp"
#include "solid/wall_layer.hpp"

namespace washtub {

/// A box of cells of this rank, [lower, upper) along each axis.
template <int D>
struct CellBox {
  Index<D> lower{}, upper{};
  bool empty() const {
    for (int d = 0; d < D; ++d)
      if (lower[d] >= upper[d]) return true;
    return false;
  }
  bool contains(const Index<D>& cell) const {
    for (int d = 0; d < D; ++d)
      if (cell[d] < lower[d] || cell[d] >= upper[d]) return false;
    return true;
  }
};

/// Maps the solids onto the grid, Eqs. (9)-(11): the open fraction 1 - H(psi) of every face, which
/// solid closes it and with what velocity. Faces are looked at again only when the solids may have
/// moved far enough to matter.
template <int D>
class DomainMapping {
 public:
  DomainMapping(const Grid<D>& grid, std::vector<Solid> solids, const Heaviside& heaviside = {});

  struct Change {
    bool any = false;      ///< some open fraction differs from before (on any rank)
    bool flipped = false;  ///< some face opened or closed at once, as the sharp function makes them
  };
  /// Moves the solids to time t (collective).
  Change update(double t);

  /// Where the solids stand and which faces they close.
  void state(Archive& archive);

  double time() const { return time_; }
  const std::vector<Solid>& solids() const { return solids_; }
  /// Open fractions of the lower faces along each axis, ghosts included.
  std::array<const float*, D> open() const {
    std::array<const float*, D> o;
    for (int d = 0; d < D; ++d) o[d] = open_[d].data();
    return o;
  }
  /// Solid with the largest psi at the lower faces along axis d, ghosts included; meaningful where
  /// not fully open.
  const std::uint8_t* owner(int d) const { return owner_[d].data(); }
  /// Along each axis, the faces whose velocity is held to one that the solids and the water farther
  /// out ask for.
  std::array<const HeldFaces*, D> held() const;
  /// Calls visit(face) for the faces of this rank along axis d that a solid closes or narrows,
  /// those deep inside a solid that never moves left out.
  template <class Visit>
  void for_surface(std::size_t solid, int d, Visit&& visit) const {
    const auto own = [&](const auto& face) {
      if (owner_[d][face.p] == solid) visit(face);
    };
    std::for_each(swept_[d].begin(), swept_[d].end(), own);
    if (!solids_[solid].drive.moving()) std::for_each(resting_[d].begin(), resting_[d].end(), own);
  }
  /// Planes of this rank that moving solids can reach, [first, last).
  std::array<int, 2> moving_planes() const { return moving_planes_; }

  /// Sets u = u_o on every closed face of a moving solid.
  void impose(std::array<Field, D>& u) const;
  /// Sets u = 0 on every face that a solid closes.
  void still(std::array<Field, D>& u) const;
  /// Faces whose opening the last update() changed.
  struct ChangedFace {
    int axis;
    std::uint8_t solid;
    long p;               ///< memory position
    Vec<D> x;             ///< its centre [m]
    float before, after;  ///< open fractions
  };
  const std::vector<ChangedFace>& changed() const { return changed_; }
  /// Share of the momentum past the solid, of a face by its open fraction, that is the water's.
  double content(float open) const;
  /// The solids as they stand now.
  const std::vector<SolidPose>& poses() const { return poses_; }

 private:
  void evaluate(const CellBox<D>& box, bool all);
  void evaluate_row(int d, int j, int k, int i0, int i1, bool all);
  float open_fraction(const Vec<3>& x, double psi, int d, const Index<D>& cell, int owner);
  void pose();
  void find_surface();
  void hold();
  bool swept(const Vec<D>& x, const Index<D>& cell) const;
  void list_surface(int d, const Index<D>& cell);
  void exchange();
  void close_sides();
  double outset(const SolidPose& solid, const Vec<3>& x, double psi) const;

  const Grid<D>& grid_;
  std::vector<Solid> solids_;
  std::vector<SolidPose> poses_;
  Heaviside heaviside_;
  WallLayer<D> layer_;
  double reach_outside_;  ///< of the solids on faces in the water [m]
  double reach_inside_;   ///< how deep in solids faces can be open [m]
  double time_ = 0, travel_ = 0;
  Change change_;
  std::array<Storage<float>, D> open_, expiry_;
  std::array<Storage<std::uint8_t>, D> owner_;
  std::vector<SurfaceFaces<D>> swept_;    ///< faces in solids where one that moves can come
  std::vector<SurfaceFaces<D>> resting_;  ///< the others, which never change
  std::vector<HeldFaces> held_;
  /// Where a solid that moves can close faces: within `radius` of its axis, in these cells.
  struct Reach {
    CellBox<D> cells;
    double radius;  ///< [m]
  };
  static Reach sweep(const Grid<D>& grid, const Solid& solid, double margin);
  std::vector<Reach> reach_;
  std::array<int, 2> moving_planes_{};

  std::vector<ChangedFace> changed_;
};

/// Point of D-dimensional space as the solids see it (z = 0 in 2-D).
template <int D>
Vec<3> in_space(const Vec<D>& x) {
  if constexpr (D == 3)
    return x;
  else
    return {x[0], x[1], 0.0};
}

}  // namespace washtub
