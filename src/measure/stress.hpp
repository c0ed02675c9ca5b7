#pragma once
#include <functional>
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "measure/statistics.hpp"

namespace washtub {

/// Stress of every node of a piece [Pa]: magnitudes of the membrane part, of the bending part at
/// the surface, and the total that Eq. (13) calls the absolute maximum (von Mises in 3-D).
struct StressField {
  std::span<const double> membrane, bending, total;
};

/// One number for each part of the stress [Pa].
struct StressParts {
  double membrane = 0, bending = 0, total = 0;
};

/// Mean of one part of the nodes' values, weighted with their area.
template <class Nodes, class Part = std::identity>
double area_mean(const Nodes& nodes, std::span<const double> area, Part part = {}) {
  Statistics s;
  for (std::size_t i = 0; i < nodes.size(); ++i) s.add(std::invoke(part, nodes[i]), area[i]);
  return s.mean();
}

/// Mean over a piece, (1/A_k) times the integral of sigma dA_k in Eq. (15) [Pa]; `area` per node
/// with borders halved.
StressParts area_mean(const StressField& stress, std::span<const double> area);

/// Eq. (15) for one part of the stress, with three standard deviations that differ in meaning [Pa].
struct StressSummary {
  double mean = 0;              ///< of time, then area of each piece, then pieces
  double over_time = 0;         ///< of the mean over all pieces, over time
  double over_pieces = 0;       ///< of the pieces' time means, over pieces
  double over_time_pieces = 0;  ///< of all pieces at all times together; the largest of the three
};

/// Collects Eq. (15) over a window. Averaging over time and over area commute, so a piece needs
/// only its area mean at each sample.
class StressStatistics {
 public:
  StressStatistics(std::size_t pieces, const Interval& window);

  /// Area means of every piece, in the same order each time, standing for the time `over`.
  void add(const Interval& over, std::span<const StressParts> pieces);
  /// All that another one of the same pieces has collected over its own window.
  void add(const StressStatistics& others);

  void state(Archive& archive) {
    archive.same_length("pieces", of_piece_);
    archive.value("all", of_all_);
  }

  StressSummary membrane() const { return summary(&Parts::membrane); }
  StressSummary bending() const { return summary(&Parts::bending); }
  StressSummary total() const { return summary(&Parts::total); }
  double time() const { return of_all_.total.weight(); }  ///< covered of the window [s]

 private:
  struct Parts {
    Statistics membrane, bending, total;
    void add(const StressParts& value, double weight);
    void add(const Parts& others);
    static constexpr bool of_doubles = true;
  };
  StressSummary summary(Statistics Parts::*part) const;

  Interval window_;
  std::vector<Parts> of_piece_;  ///< each piece's area mean over time
  Parts of_all_;                 ///< mean over pieces, over time
};

}  // namespace washtub
