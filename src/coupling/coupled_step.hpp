#pragma once
#include <memory>
#include <vector>

#include "base/phase_clock.hpp"
#include "cloth/nodal_force.hpp"
#include "contact/barrier.hpp"
#include "contact/contact.hpp"
#include "coupling/inertia.hpp"
#include "coupling/permeability.hpp"
#include "flow/flow.hpp"

namespace washtub {

/// What a coupled step found.
template <int D>
struct CouplingReport {
  int iterations = 0;         ///< most Newton steps of any piece, or Broyden steps
  double largest_strain = 0;  ///< |E| of any edge
  /// How nodes move past the water; 0 in a step in which it was not looked at.
  double slip = 0;      ///< rms over the nodes not pinned of |V - S u| [m/s]
  double leak = 0;      ///< rms over the pinned nodes of |S u| [m/s]
  bool looked = false;  ///< whether it was
  typename Barrier<D>::Report barrier;
  typename Contact<D>::Report contact;
};

/// The step of cloth and water under way, on which Coupling and its scheme work.
template <int D>
struct CoupledStep {
  using Nodes = std::vector<Vec<D>>;

  /// `clock`: where the time goes; may be null.
  CoupledStep(Flow<D>& flow, Cloth<D>& cloth, PhaseClock* clock);

  double dt() const { return flow.step(); }  ///< [s]
  /// cloth.elastic = -dW/dX(X).
  void find_elastic(const Nodes& X);
  /// given = the forces of the list, as they are when the step begins, with nodes that go with a
  /// velocity [m/s] (collective).
  void find_given(const Nodes& velocity);
  /// Of the forces of the list since the start [J]; per metre in 2-D.
  double work_of_given() const;
  void state(Archive& archive);
  /// force = elastic force, given ones and inertia, as they were found last.
  void add_up_force();
  /// What a node gives way to a unit of force in this step, by moving the water and past it [m/N].
  Mat<D> yield(std::size_t node) const;
  /// Largest strain of the cloth at `next`, into the report.
  void measure_strain();

  PhaseClock* clock;
  Flow<D>& flow;
  Cloth<D>& cloth;
  ClothSurface<D> surface;
  Inertia<D> inertia;
  Permeability<D> permeability;
  std::vector<std::unique_ptr<NodalForce<D>>> forces;
  std::vector<int> pinned;  ///< nodes that never move
  /// Velocity of the water at the nodes [m/s]: before the projection with the force and pressure of
  /// the last step, then u^n+1 and what cloth moves past it by the force of this step, with 0 at
  /// pinned nodes.
  Nodes water;
  Nodes carried;           ///< velocity that the forces of the list see [m/s]
  Nodes mobility;          ///< D of the nodes [1/kg]
  Nodes given;             ///< sum of the forces of the list [N]
  double time_given = 0;   ///< how long they act: the step [s]
  double work_before = 0;  ///< of such forces in the steps before [J]
  Nodes force;             ///< G: total force of each node on the water [N]
  Nodes next;              ///< X^n+1 [m]
  CouplingReport<D> report;
};

}  // namespace washtub
