#pragma once
#include <optional>
#include <vector>

#include "cloth/stress.hpp"
#include "measure/scatter.hpp"
#include "measure/stress.hpp"
#include "measure/trajectory.hpp"
#include "record/exact.hpp"
#include "washer/simulation.hpp"

namespace washtub {

/// What one solid felt since the sample before.
struct SolidSample {
  double angle = 0;       ///< [rad]
  double speed = 0;       ///< mean since the sample before [rad/s]
  double torque = 0;      ///< of the water on it: mean since then if it turns, else now [N m]
  double friction = 0;    ///< skin friction part, now [N m]
  double pressure = 0;    ///< pressure part, now [N m]
  double convection = 0;  ///< momentum carried into the staircase, now [N m]
  Vec<3> force = Vec<3>::Zero();  ///< of the water on it, all parts, now [N], per metre in 2-D
};

/// One row of history: the state at an instant and the means since the one before.
struct Sample {
  double time = 0;
  std::vector<SolidSample> solids;
  std::vector<StressParts> pieces;  ///< area means [Pa]
  StressParts stress;               ///< mean over the pieces [Pa]
  std::vector<Vec<2>> centres;      ///< (r, z) of each piece [m]
  Vec<2> centre = Vec<2>::Zero();   ///< of all pieces [m]
  std::vector<Vec<3>> probes;       ///< places of the case's probes [m]
  double enclosed_area = 0;         ///< mean over the rings [m^2]
  VelocityError error;              ///< from the exact velocity, where the case gives one
};

/// Whether a thread is closed without a shift, and so encloses an area.
bool is_ring(const Sheet<2>& sheet);

/// Watches a simulation: a sample whenever asked, and the statistics of all samples in the window.
template <int D>
class Observer {
 public:
  explicit Observer(Simulation<D>& simulation);

  /// Takes a sample (collective).
  const Sample& observe();

  const std::vector<Sample>& samples() const { return samples_; }
  const std::vector<double>& membrane() const { return membrane_; }  ///< per node, last sample [Pa]
  const std::vector<double>& bending() const { return bending_; }
  const std::vector<double>& total() const { return total_; }
  const StressStatistics& stress() const { return stress_; }
  const Scatter& scatter() const { return scatter_; }
  /// Of every whole cycle of the window that has begun.
  const std::vector<Scatter>& scatter_of_cycles() const { return scatter_of_cycles_; }
  const Interval& window() const { return window_; }
  /// Largest values over all steps so far.
  struct Extremes {
    double divergence = 0, slip = 0, penetration = 0, strain = 0, courant = 0;
    double slip_share = 0, sum_of_slip_shares = 0;  ///< rms slip over the largest speed
    long touched = 0, cycles = 0, unconverged = 0, newton = 0;
    double largest_step = 0, smallest_step = 1e30;
  };
  /// Statistics so far (collective).
  void state(Archive& archive);
  /// To be called after every step.
  void watch(const typename Simulation<D>::Step& step);
  const Extremes& extremes() const { return extremes_; }

 private:
  void observe_solids(Sample& s);
  void observe_cloth(Sample& s, const Interval& since);
  void observe_scatter(const Interval& since);
  void observe_probes(Sample& s) const;
  void observe_rings(Sample& s) const;

  Simulation<D>& simulation_;
  Interval window_;
  Vec<2> axis_;
  StressStatistics stress_;
  Scatter scatter_;
  std::vector<Interval> cycles_;
  std::vector<Scatter> scatter_of_cycles_;
  std::optional<ExactSolution<D>> exact_;
  std::vector<Sample> samples_;
  std::vector<NodeStress> node_stress_;
  std::vector<double> membrane_, bending_, total_;
  Extremes extremes_;
};

}  // namespace washtub
