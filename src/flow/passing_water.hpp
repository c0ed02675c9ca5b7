#pragma once
#include "flow/sides.hpp"

namespace washtub {

/// Water that passes the sides of the box: keeps the normal velocity on inflow, outflow and
/// far-field sides and the tangential ghosts beyond outflows. The pressure takes the normal
/// velocity on all sides as given, so what enters has to leave.
template <int D>
class PassingWater {
 public:
  /// @throws InputError when water enters and no side lets it out.
  PassingWater(const Grid<D>& grid, const SidePairs<D>& sides);

  /// Moves the values on the sides by dt: du/dt + c du/dn = 0 (App. B), upwind, with c the mean
  /// normal velocity over the outflow sides or a tenth of the fastest inflow (of `speed` without
  /// inflow), whichever is larger. Then one velocity is added to all outflow and far-field faces so
  /// that no water is lost. Faces let through what is open one cell inside, by the open
  /// fractions `open`. Collective.
  void advance(const std::array<double*, D>& u, const std::array<const float*, D>& open, double dt,
               double speed);

  void state(Archive& archive) { archive.value("mean outflow", mean_outflow_); }

  double fastest_inflow() const { return fastest_inflow_; }  ///< [m/s]

 private:
  using Kind = typename Side<D>::Kind;
  /// What leaves the box [m^3/s], (m^2/s in 2-D) and the area it has.
  struct Sums {
    double flux = 0, open_area = 0, outflow = 0, outflow_area = 0;
  };
  struct Step {
    long face, inside;
    double out;
  };
  static bool lets_out(Kind kind) { return kind == Kind::outflow || kind == Kind::far_field; }

  Step step(int axis, int side) const;
  template <class Visit>
  void for_cells(int axis, int side, Visit&& visit) const;
  template <class Visit>
  void for_sides(Visit&& visit) const;
  void enter(int axis, int side, double* u, const float* open, Sums& sums) const;
  void leave(int axis, int side, double* u, const float* open, double share, Sums& sums) const;
  void drag_ghosts(int axis, int side, const std::array<double*, D>& u, double share) const;

  const Grid<D>& grid_;
  SidePairs<D> sides_;
  bool any_ = false;
  double fastest_inflow_ = 0;
  double mean_outflow_ = 0;  ///< normal velocity over the outflow sides after the last advance()
};

}  // namespace washtub
