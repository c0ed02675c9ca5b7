#pragma once
#include <array>
#include <optional>
#include <string>

#include "measure/persistence.hpp"
#include "record/quality.hpp"
#include "washer/simulation.hpp"

namespace washtub {

/// Watches how well the grid resolves the water, where its energy goes, and cloth passing through
/// cloth. All is collective.
template <int D>
class SelfWatch {
 public:
  explicit SelfWatch(const Simulation<D>& simulation);

  /// For a row of the history. `power`: of the drives on the water, mean since the row before [W].
  const QualitySample& observe(double power);
  /// Cloth through cloth and near to cloth as it is, for a frame.
  void look_at_cloth();
  /// The run has started from something that its reader must know of.
  void note_start(const std::string& sentence) { quality_.start = sentence; }
  /// A paragraph on a flow that is not resolved, once: when the first row shows it.
  std::optional<std::string> first_alarm();

  void state(Archive& archive);
  const Quality& quality() const { return quality_; }

 private:
  EnergyState energy_now(double work) const;
  void count_crossings();

  const Simulation<D>& simulation_;
  SidePairs<D> sides_;
  bool closed_;
  bool alarmed_ = false;
  EnergyState energy_;
  double power_of_sides_ = 0;              ///< at the last row [W]
  double work_on_cloth_ = 0;               ///< of weight, load and repulsion up to the last row [J]
  std::array<Persistence, 2> near_later_;  ///< a quarter and a whole period of the drive later
  QualitySample row_;
  Quality quality_;
};

}  // namespace washtub
