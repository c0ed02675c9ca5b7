#pragma once
#include <memory>
#include <vector>

#include "cloth/cloth.hpp"
#include "cloth/implicit.hpp"
#include "coupling/barrier.hpp"
#include "coupling/broyden.hpp"
#include "coupling/immersed_boundary.hpp"
#include "coupling/scheme.hpp"

namespace washtub {

/// Moves cloth and water together. Between Flow::predict and Flow::project, push() finds the
/// cloth's force on the water; after the projection, move() brings the cloth to its new place.
///
/// The implicit scheme takes the water that a node drags along as a mass m_i = 1/D_i ("ghost mass",
/// D the lumped mobility) and minimises sum m_i |Y - Z|^2 / (2 dt^2) + W(Y), with Z where the node
/// would go if the forces of the step before went on. It is linearly stable for any stiffness.
///
/// The Broyden scheme is the paper's for 2-D: X = X^n + dt U, Eq. (6), with U the velocity of the
/// projected water under the force of X itself, so that each iteration costs a projection. Force
/// and inertia are taken at X^n+1, the delta functions stay at X^n + dt V^n / 2: with spreading and
/// interpolation at the same places backward Euler loses energy for any step (Newren et al., J.
/// Comput. Phys. 222, 2007); a trapezoidal force would leave the stiffest waves undamped, and delta
/// functions at X^n+1 would make the equation rougher for the same order in time. The iteration,
/// not stability, limits the step.
///
/// A pinned node stays where it is, and its force on the water is the last one less m_i U / dt,
/// with U what the water's velocity there would become otherwise. That goes on until the water
/// rests.
template <int D>
class Coupling {
 public:
  Coupling(Flow<D>& flow, Cloth<D>& cloth, const DomainMapping<D>& mapping, Kernel kernel,
           const std::array<std::array<Side<D>, 2>, D>& sides, Scheme scheme,
           double marker_spacing = 2);

  struct Report {
    int iterations = 0;         ///< most Newton steps of any piece, or Broyden steps
    double largest_strain = 0;  ///< |E| of any edge
    double slip = 0;            ///< rms over the nodes not pinned of |V - S u| [m/s]
    double largest_slip = 0;    ///< [m/s]
    double leak = 0;            ///< rms over the pinned nodes of |S u| [m/s]
    typename Barrier<D>::Report barrier;
  };

  /// Gravity [m/s^2] acts on the mass of the cloth beyond that of the displaced water.
  void set_gravity(const Vec<D>& gravity) { gravity_ = gravity; }

  /// On return flow.force() is the force of the cloth on the water during this step.
  /// @throws RunError naming the piece whose solve failed
  void push(double dt);
  /// To be asked after each projection. True if another one is needed: then flow.force() is a
  /// better force, and the flow is back at its prediction. Only the Broyden scheme ever needs it.
  /// @throws RunError when the iteration does not converge
  bool again(double dt);
  /// On return the cloth is at its new place, outside all solids.
  Report move(double dt);

  void state(Archive& archive) {
    archive.same_length("force", force_);
    archive.value("last step", last_step_);
    archive.value("barrier", barrier_);
  }

  /// Moment of the contact forces on a solid about its axis [N m], in the last step.
  double contact_moment(std::size_t solid) const;

 private:
  using Nodes = std::vector<Vec<D>>;
  static constexpr int not_held = -2;
  void find_pins(double dt);
  void find_water(double dt);
  void find_inertia();
  bool heavy(std::size_t node, int component) const;
  void find_implicit_inertia(double dt, bool all);
  void spread_force();
  void solve(double dt);
  void start_iteration(double dt);
  double find_residual(double dt);
  void measure_strain();
  void measure_slip();
  void solve_group(std::size_t g, const std::vector<int>& pieces);
  void keep_out(double dt);
  void add_reactions();
  void find_elastic(const Nodes& X);
  void share_among_ranks(Nodes& values, std::size_t g) const;

  Flow<D>& flow_;
  Cloth<D>& cloth_;
  const DomainMapping<D>& mapping_;
  Scheme scheme_;
  ImmersedBoundary<D> boundary_;
  Barrier<D> barrier_;
  std::vector<std::unique_ptr<ClothSolver<D>>> solvers_;
  std::vector<std::vector<int>> mine_;  ///< pieces of each group that this rank solves
  std::vector<double> excess_;          ///< excess mass of each node [kg]
  Components<D> provisional_;
  Nodes next_, middle_, target_, free_, stiffness_, mobility_, carried_, water_;
  Broyden<D> broyden_;
  Nodes residual_;            ///< X - X^n - dt U [m]
  std::vector<double> size_;  ///< smallest node spacing of each node's piece [m]
  std::vector<int> pinned_;   ///< nodes that never move
  Nodes pin_force_;           ///< force of each pinned node on the water [N]
  std::vector<int> held_by_;  ///< solid that holds each node off itself, no_solid, or free
  std::vector<int> held_;     ///< nodes that are held off something in this step
  Nodes reaction_;            ///< force of solids and sides on held nodes [N]
  Nodes force_;               ///< G: total force of each node on the water [N]
  Vec<D> gravity_ = Vec<D>::Zero();
  double last_step_ = 0;
  Report report_;
};

}  // namespace washtub
