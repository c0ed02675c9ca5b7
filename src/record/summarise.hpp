#pragma once
#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/phase_clock.hpp"
#include "case/groups.hpp"
#include "io/table.hpp"
#include "measure/cloth_statistics.hpp"
#include "measure/trajectory.hpp"
#include "record/declared.hpp"
#include "record/extremes.hpp"
#include "record/quality.hpp"
#include "record/quantities.hpp"

namespace washtub {

/// Seconds that a rank spent in each phase.
using PhaseTimes = std::array<double, phases>;

/// "projection 12.3 s (41 %), ..." in the order of the phases; those without time are left out.
std::string phases_text(const PhaseTimes& times);

/// What a run itself knows at its end; the rest of its summary comes from its tables.
struct RunEnd {
  std::string outcome;  ///< "complete", "stopped" or the reason of a failure
  double time = 0;      ///< [s]
  long steps = 0;
  int ranks = 1;
  double wall_time = 0;  ///< [s]
  int frames = 0;
  Extremes extremes = {};
  Quality quality = {};
  PhaseTimes phases = {};
};

/// What the entries on the case and its window are taken from.
struct TopSource {
  const Case& whole;
  const Averaging& span;
};

/// Those on the run.
struct RunSource {
  const Case& whole;
  const RunEnd& end;
};

/// Those on its cloth.
struct ClothSource {
  const Case& whole;
  const ClothStatistics& statistics;
  ClothStatistics::Part all;
  const CsvTable& history;
};

/// One part of the stress.
struct StressSource {
  StressSummary stress;
  std::optional<Scales> scale;
};

/// The paths of the pieces over the span of the statistics.
struct LoopSource {
  LoopSource(const Case& whole, const CsvTable& tracks);

  VelocityMap map;
  double area = 0, turns = 0;  ///< means over the pieces
};

/// An entry of summary.json as it is declared; null where it has no value.
template <class Source>
struct DeclaredEntry {
  Declared about;
  nlohmann::ordered_json (*take)(const Source&);
};

/// The declarations of summary.json, in the order of its entries.
namespace entries {
extern const std::vector<DeclaredEntry<TopSource>> top;
extern const std::vector<DeclaredEntry<RunSource>> run, phases, coupling, quality;
extern const std::vector<DeclaredEntry<Scales>> scales;
extern const std::vector<DeclaredEntry<ClothSource>> cloth;
extern const std::vector<DeclaredEntry<StressSource>> stress;
extern const std::vector<DeclaredEntry<LoopSource>> loop;
}  // namespace entries

/// Name of an entry, with its unit: "wall time [s]".
std::string entry_name(const Declared& about, int dimension);

/// summary.json: run facts, and statistics over the window with their uncertainty, from the rows of
/// its tables; `tracks` is null where there is no cloth.
nlohmann::ordered_json summarise(const Case& whole, const RunEnd& end, const ClothStatistics& cloth,
                                 const CsvTable& history, const CsvTable* tracks);

}  // namespace washtub
