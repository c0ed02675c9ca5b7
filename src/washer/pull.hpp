#pragma once
#include <vector>

#include "case/case.hpp"
#include "case/vector_field.hpp"
#include "cloth/cloth.hpp"
#include "cloth/nodal_force.hpp"

namespace washtub {

/// The force that a case lets pull at its cloth, given over the area at rest by formulas of place
/// and time, which are taken where the nodes are when a step begins and at the end of it.
template <int D>
class Pull : public NodalForce<D> {
 public:
  /// @throws InputError where a formula has no finite value at t = 0
  Pull(const Cloth<D>& cloth, const Case& whole);
  /// Whether a case has any.
  static bool any(const Case& whole);

  /// @throws RunError where a formula has no finite value now
  void add(const ClothMoment<D>& now, std::vector<Vec<D>>& force) override;
  void state(Archive& archive) override { archive.value("time", time_); }

 private:
  void add_forces(const std::vector<Vec<D>>& X, std::vector<Vec<D>>& force) const;
  struct Group {
    std::size_t first, last;  ///< nodes
    VectorField<D> field;     ///< [Pa]
  };

  std::vector<Group> groups_;  ///< those that are pulled at
  std::vector<double> area_;   ///< of each node [m^2]; in 2-D length [m]
  double time_ = 0;            ///< at the end of the last step [s]
};

}  // namespace washtub
