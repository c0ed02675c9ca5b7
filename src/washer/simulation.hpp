#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "case/case.hpp"
#include "coupling/coupling.hpp"
#include "solid/surface_water.hpp"
#include "washer/slip_cut.hpp"

namespace washtub {

/// What keeps the time step from being longer.
enum class StepLimit { given, courant, growth, sample, slip, caution };
const char* name(StepLimit limit);

/// Sums over the steps since the last look of what the water does to a turning solid; per metre in
/// 2-D. The torque tau of a step is the mean over it.
struct Impulse {
  double moment = 0;   ///< integral of tau dt [N m s]
  double work = 0;     ///< integral of tau d(angle) [J]: minus what the solid gives to the water
  double squared = 0;  ///< integral of tau^2 dt [N^2 m^2 s]
  double angle = 0;    ///< swept [rad]
  double time = 0;     ///< [s]
  static constexpr bool of_doubles = true;
};

/// A case that runs: water, solids and cloth, and the step that moves them on together.
template <int D>
class Simulation {
 public:
  /// Places the cloth at rest, and sets the water's velocity at t = 0.
  /// With `developed`, an archive of another simulation's state, water and cloth start as they are
  /// there; time, solids and everything else are those of this case. With `places` the cloth rests
  /// there instead, a place for each node [m].
  /// @throws InputError where the cloth does not fit or the grid does not suit the ranks, or where
  /// the developed state has another grid or other cloth
  Simulation(const Case& whole, const Parallel& parallel, Archive* developed = nullptr,
             const std::vector<Vec<D>>& places = {});

  /// All that goes on from step to step (collective).
  void state(Archive& archive);
  /// The next steps are at most `share` of what they would be, where their length is not fixed, and
  /// the pressure solve may take 1 / share^2 as many cycles; that wears off over a hundred steps.
  void be_cautious(double share) { caution_ = share; }

  struct Step {
    long number = 0;
    double time = 0, dt = 0;  ///< [s]
    StepLimit limit = StepLimit::given;
    double courant = 0;     ///< sum over axes of |u| dt / h, largest
    double divergence = 0;  ///< |div u| h / U, largest
    double speed = 0;       ///< largest velocity component [m/s]
    double kinetic = 0;     ///< energy of the water [J]
    SolveReport pressure;
    typename Coupling<D>::Report cloth;
    int flips = 0;  ///< 1 if a face opened or closed in this step
  };
  /// One step, ending at `latest` at the latest unless its length is fixed.
  /// @throws RunError when the state makes no sense any more, PressureError where it is the
  /// pressure solve that failed; the state is left as it is for a last look
  const Step& step(double latest);

  /// Whether the state is made of numbers still: no NaN or infinity in water or cloth.
  bool finite() const;

  double time() const { return last_.time; }
  const Step& last() const { return last_; }
  const Grid<D>& grid() const { return grid_; }
  const Flow<D>& flow() const { return flow_; }
  const Cloth<D>& cloth() const { return cloth_; }
  const DomainMapping<D>& mapping() const { return mapping_; }
  const Case& definition() const { return case_; }
  /// Of this rank: after a step it is in Phase::rest.
  PhaseClock& clock() { return clock_; }
  const PhaseClock& clock() const { return clock_; }
  /// Of the fastest surface, side or inflow; else of the water at the start [m/s].
  double driving_speed() const { return driving_speed_; }
  /// Of weight, load and repulsion on the cloth since the start [J]; per metre in 2-D.
  double work_on_cloth() const { return coupling_ ? coupling_->work_of_forces() : 0; }
  /// Impulse on a turning solid of the case since the last call, the same on all ranks.
  Impulse take_impulse(std::size_t solid);
  /// Loads on a solid of the case now, summed over its images and the ranks (collective).
  SurfaceLoads<D> loads(std::size_t solid) const;

 private:
  void add_forces();
  void start_water();
  void take_developed(Archive& developed);
  void measure_start();
  double start_rate() const;
  double start_step() const;
  double choose_step(double latest);
  int most_cycles() const;
  void find_surface_momenta();
  void move_solids(double dt);
  void move_cloth_and_water(double dt, bool measure_slip);
  void record_impulses(double dt);
  void watch() const;
  WaterState<D> water() const;

  PhaseClock clock_;
  Case case_;
  Grid<D> grid_;
  DomainMapping<D> mapping_;
  Flow<D> flow_;
  SurfaceWater<D> surface_water_;
  Cloth<D> cloth_;
  std::optional<Coupling<D>> coupling_;
  Step last_;
  double courant_rate_ = 0;  ///< largest sum over axes of |u| / h [1/s]
  SlipCut slip_cut_;
  double caution_ = 1;
  double driving_speed_ = 0;
  double wanted_step_ = 0;               ///< before it was cut to meet the sample [s]
  std::vector<Impulse> impulses_;        ///< on all ranks
  std::vector<double> moments_;          ///< of tau dt of this step, this rank's share [N m s]
  std::vector<double> surface_momenta_;  ///< SurfaceWater::momentum() about the axis [N m s]
};

}  // namespace washtub
