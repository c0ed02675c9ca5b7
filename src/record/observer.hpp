#pragma once
#include <optional>
#include <vector>

#include "cloth/stress.hpp"
#include "measure/cloth_statistics.hpp"
#include "measure/quantiles.hpp"
#include "record/exact.hpp"
#include "record/extremes.hpp"
#include "record/self_watch.hpp"
#include "washer/simulation.hpp"

namespace washtub {

/// Watches a simulation: a sample whenever asked, and what of the statistics the samples in the
/// tables cannot tell. It keeps none of them.
template <int D>
class Observer {
 public:
  explicit Observer(Simulation<D>& simulation);

  /// Takes a sample (collective).
  Sample observe();

  const std::vector<double>& membrane() const { return membrane_; }  ///< per node, last sample [Pa]
  const std::vector<double>& bending() const { return bending_; }
  const std::vector<double>& total() const { return total_; }
  const ClothStatistics& cloth() const { return statistics_; }
  double sampled() const { return sampled_; }  ///< time of the last sample [s]
  /// Statistics so far (collective).
  void state(Archive& archive);
  /// To be called after every step.
  void watch(const typename Simulation<D>::Step& step);
  const Extremes& extremes() const { return extremes_; }
  SelfWatch<D>& self_watch() { return self_watch_; }
  const Quality& quality() const { return self_watch_.quality(); }

 private:
  double least_speed() const;
  ClothStatistics no_statistics() const;
  StepSample observe_step() const;
  QualitySample observe_quality(const std::vector<SolidSample>& solids);
  SolidSample observe_solid(std::size_t solid, double time);
  void observe_cloth(Sample& s, const Interval& since);
  PieceSample observe_piece(const ClothGroup<D>& group, int piece);
  void count_cycles();
  void observe_quantiles(Sample& s);
  void observe_cycles(Sample& s, const Interval& since);
  void collect(const std::vector<PieceSample>& pieces, const Interval& since);
  void observe_probes(Sample& s) const;
  void observe_rings(Sample& s) const;

  Simulation<D>& simulation_;
  Vec<2> axis_;
  ClothStatistics statistics_;
  std::optional<ExactSolution<D>> exact_;
  double sampled_;  ///< time of the last sample [s]
  SteadyStrains<D> steady_;
  std::vector<Rainflow> cycles_;  ///< of the strains of each group's edges
  Strains strains_;               ///< of a piece now
  std::vector<NodeStress> node_stress_;
  std::vector<double> membrane_, bending_, total_;
  Extremes extremes_;
  SelfWatch<D> self_watch_;
};

}  // namespace washtub
