#pragma once
#include "cloth/implicit.hpp"
#include "contact/solid_hold.hpp"
#include "coupling/coupling_scheme.hpp"

namespace washtub {

/// Takes the water that a node drags along as a mass m_i = 1/D_i ("ghost mass", D the lumped
/// mobility) and minimises sum m_i |Y - Z|^2 / (2 dt^2) + W(Y), with Z where the node would go if
/// the forces of the step before went on. Linearly stable for any stiffness. The inertia of heavy
/// cloth is part of the minimum, that of light cloth lags a step. Where cloth lets water through
/// with P, (dt^2/m + dt P)^-1 takes the place of m/dt^2.
///
/// What would come too near to something is held off it and solved again, until nothing is left to
/// hold. What that takes are the forces of surfaces on nodes, and of parts of the cloth on each
/// other.
template <int D>
class ImplicitScheme : public CouplingScheme<D> {
 public:
  ImplicitScheme(CoupledStep<D>& step, Barrier<D>& barrier, Contact<D>* contact);

  bool needs_provisional() const override { return true; }
  bool needs_projected() const override { return false; }
  /// @throws RunError naming the piece whose solve failed
  void push() override;
  double contact_moment(int solid, const Vec<3>& axis) const override;
  void state(Archive& archive) override { archive.value("solids", solids_); }

 private:
  using Nodes = std::vector<Vec<D>>;

  bool heavy(std::size_t node) const;
  void find_target(std::size_t node);
  void find_targets();
  void solve_group(std::size_t g, const std::vector<int>& pieces);
  void share_among_ranks(std::size_t g, Nodes& values);
  void hold_off();
  bool bind_pushed();
  void solve_again();
  void add_reactions();

  CoupledStep<D>& step_;
  Barrier<D>& barrier_;
  std::vector<std::unique_ptr<ClothSolver<D>>> solvers_;
  std::vector<std::vector<int>> mine_;  ///< pieces of each group that this rank solves
  SolidHold<D> solids_;
  Contact<D>* contact_;
  std::vector<Mat<D>> inertia_;    ///< m/dt^2, less where cloth lets water through [N/m]
  std::vector<Mat<D>> yield_;      ///< its inverse
  Nodes free_;                     ///< Z of nodes that nothing holds [m]
  Nodes push_;                     ///< of parts of the cloth on each other [N]
  std::vector<Mat<D>> stiffness_;  ///< inertia and what holds the node [N/m]
  Nodes target_;                   ///< where both together draw it [m]
  std::vector<char> pushed_;       ///< nodes whose hold has changed
  std::vector<int> piece_;         ///< of each node, among all pieces
  std::vector<char> stale_;        ///< pieces that have to be solved again
  std::vector<int> pieces_;        ///< of a group that this rank solves again
};

}  // namespace washtub
