#pragma once
#include "cloth/implicit.hpp"
#include "coupling/coupling_scheme.hpp"

namespace washtub {

/// Takes the water that a node drags along as a mass m_i = 1/D_i ("ghost mass", D the lumped
/// mobility) and minimises sum m_i |Y - Z|^2 / (2 dt^2) + W(Y), with Z where the node would go if
/// the forces of the step before went on. Linearly stable for any stiffness. The inertia of heavy
/// cloth is part of the minimum, that of light cloth lags a step.
///
/// Nodes that would come too near a surface are held off it. What that takes is the force of the
/// surface on them.
template <int D>
class ImplicitScheme : public CouplingScheme<D> {
 public:
  ImplicitScheme(CoupledStep<D>& step, Barrier<D>& barrier);

  bool needs_provisional() const override { return true; }
  bool needs_projected() const override { return false; }
  /// @throws RunError naming the piece whose solve failed
  void push() override;
  double contact_moment(int solid, const Vec<3>& axis) const override;

 private:
  using Nodes = std::vector<Vec<D>>;
  static constexpr int not_held = -2;

  bool heavy(int node, int component) const;
  void find_targets();
  void solve_group(std::size_t g, const std::vector<int>& pieces);
  void share_among_ranks(std::size_t g);
  void keep_out();
  bool hold_contacts();
  void solve_again();
  void add_reactions();

  CoupledStep<D>& step_;
  Barrier<D>& barrier_;
  std::vector<std::unique_ptr<ClothSolver<D>>> solvers_;
  std::vector<std::vector<int>> mine_;  ///< pieces of each group that this rank solves
  Nodes stiffness_;                     ///< m/dt^2 [N/m]
  Nodes free_;                          ///< Z [m]
  Nodes target_;                        ///< Z, or where a node has to be [m]
  std::vector<int> held_by_;            ///< solid that holds each node off itself, or not_held
  std::vector<int> held_;               ///< nodes that are held off something in this step
  Nodes reaction_;                      ///< force of solids and sides on held nodes [N]
  std::vector<int> piece_;              ///< of each node, among all pieces
  std::vector<char> stale_;             ///< pieces that have to be solved again
  std::vector<int> pieces_;             ///< of a group that this rank solves again
};

}  // namespace washtub
