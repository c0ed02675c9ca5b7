#pragma once
#include <memory>
#include <vector>

#include "cloth/cloth.hpp"
#include "cloth/implicit.hpp"
#include "coupling/barrier.hpp"
#include "coupling/immersed_boundary.hpp"
#include "coupling/scheme.hpp"

namespace washtub {

/// Moves cloth and water together. Between Flow::predict and Flow::project, push() finds the
/// cloth's force on the water; after the projection, move() brings the cloth to its new place.
///
/// The implicit scheme takes the water that a node drags along as a mass m_i = 1/D_i ("ghost mass",
/// D the lumped mobility) and minimises sum m_i |Y - Z|^2 / (2 dt^2) + W(Y), with Z where the node
/// would go if the forces of the step before went on. It is linearly stable for any stiffness.
template <int D>
class Coupling {
 public:
  Coupling(Flow<D>& flow, Cloth<D>& cloth, const DomainMapping<D>& mapping, Kernel kernel,
           const typename ImmersedBoundary<D>::Reflections& sides, Scheme scheme,
           double marker_spacing = 2);

  struct Report {
    int iterations = 0;         ///< most Newton steps of any piece
    double largest_strain = 0;  ///< |E| of any edge
    double slip = 0;            ///< rms over the nodes of |V - S u| [m/s]
    double largest_slip = 0;    ///< [m/s]
    typename Barrier<D>::Report barrier;
  };

  /// On return flow.force() is the force of the cloth on the water during this step.
  /// @throws RunError naming the piece whose solve failed
  void push(double dt);
  /// On return the cloth is at its new place, outside all solids.
  Report move(double dt);

  /// Moment of the contact forces on a solid about its axis [N m], in the last step.
  double contact_moment(std::size_t solid) const;

 private:
  using Nodes = std::vector<Vec<D>>;
  void find_inertia();
  void solve(double dt);
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
  typename ImmersedBoundary<D>::Components provisional_;
  Nodes next_, middle_, target_, free_, stiffness_, mobility_, carried_, water_;
  std::vector<int> held_by_;  ///< solid that holds each node off itself, no_solid, or free
  std::vector<int> held_;     ///< nodes that are held off something in this step
  Nodes reaction_;            ///< force of solids and sides on held nodes [N]
  Nodes force_;               ///< G: total force of each node on the water [N]
  double last_step_ = 0;
  Report report_;
};

}  // namespace washtub
