#pragma once
#include <cstdint>
#include <vector>

#include "grid/grid.hpp"
#include "solid/solid.hpp"
#include "solid/surface_faces.hpp"

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
  /// `gamma`: half width of the smooth Heaviside function, Eq. (11) [m]; 0 takes the sharp one.
  /// `shift`: how far outside the surface the sharp one still closes a face, over sum_d |n_d| h_d,
  /// the width of a cell along the normal.
  DomainMapping(const Grid<D>& grid, std::vector<Solid> solids, double gamma, double shift = 0);

  struct Change {
    bool any = false;      ///< some open fraction differs from before (on any rank)
    bool flipped = false;  ///< some face opened or closed at once, as the sharp function makes them
  };
  /// Moves the solids to time t (collective).
  Change update(double t);

  /// Where the solids stand and which faces they close.
  void state(Archive& archive);

  double time() const { return time_; }
  bool smooth() const { return gamma_ > 0; }
  const std::vector<Solid>& solids() const { return solids_; }
  /// Open fractions of the lower faces along each axis, ghosts included.
  std::array<const float*, D> open() const;
  /// Solid with the largest psi at the lower faces along axis d, ghosts included; meaningful where
  /// not fully open.
  const std::uint8_t* owner(int d) const { return owner_[d].data(); }
  /// Faces of this rank along axis d that are not fully open, those deep inside solids that never
  /// move aside.
  const SurfaceFaces<D>& surface(int d) const { return surface_[d]; }
  /// Planes of this rank that moving solids can reach, [first, last).
  std::array<int, 2> moving_planes() const { return moving_planes_; }

  /// Sets u = u_o on every closed face of a moving solid.
  void impose(std::array<Field, D>& u) const { set_solid_velocity(u, 0.0F); }
  /// Sets u = u_o on every face of a moving solid that is not fully open.
  void impose_target(std::array<Field, D>& target) const { set_solid_velocity(target, 0.9999999F); }
  /// Sets u = 0 on every face that a solid closes.
  void still(std::array<Field, D>& u) const;
  /// Momentum that the faces opened and closed by the last update() hand to a solid when the
  /// velocity is still the one before impose(): force x time and moment x time about its axis.
  std::pair<Vec<D>, double> swept(std::size_t solid, const std::array<Field, D>& u,
                                  double density) const;
  /// The solids as they stand now.
  const std::vector<SolidPose>& poses() const { return poses_; }

 private:
  void evaluate(const CellBox<D>& box, bool all);
  void evaluate_row(int d, int j, int k, int i0, int i1, bool all);
  void pose();
  void find_surface();
  bool counts(const Vec<D>& x, int owner, const Index<D>& cell) const;
  void exchange();
  void close_sides();
  void set_solid_velocity(std::array<Field, D>& u, float open_at_most) const;
  double outset(const SolidPose& solid, const Vec<3>& x, double psi) const;
  float open_fraction(double psi) const;

  const Grid<D>& grid_;
  std::vector<Solid> solids_;
  std::vector<SolidPose> poses_;
  double gamma_, shift_;
  double reach_outside_;  ///< of the solids on the faces [m]: gamma, or the largest shift
  double time_ = 0, travel_ = 0;
  Change change_;
  std::array<Storage<float>, D> open_, expiry_;
  std::array<Storage<std::uint8_t>, D> owner_;
  std::vector<SurfaceFaces<D>> surface_;
  std::vector<CellBox<D>> reach_;  ///< cells whose faces a solid that moves can close; whole block
                                   ///< for others
  std::array<int, 2> moving_planes_{};

  struct Swept {
    int axis;
    std::uint8_t solid;
    long p;        ///< memory position of the face
    Vec<D> x;      ///< its centre [m]
    float closed;  ///< decrease of its open fraction
  };
  std::vector<Swept> swept_;
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
