#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "measure/pool.hpp"
#include "record/quantities.hpp"
#include "report/comparison.hpp"

namespace washtub {

/// A quantity of all members.
struct PooledQuantity {
  RunQuantity about;  ///< mean, with the means of the members that have it as batches, and seeds
  std::vector<std::vector<double>> batches;  ///< of each of these members
  Pool pool;
  Drift drift;
  /// For a half width of 5 % of the mean: members, and whole cycles of one run. NaN: cannot be
  /// told, as where single runs do not cover the spread between them.
  double seeds_wanted = 0, cycles_wanted = 0;
};

/// Runs of one case from different random starts.
struct Ensemble {
  std::string directory, name;
  std::vector<std::uint64_t> seeds;    ///< of the members
  std::vector<std::uint64_t> missing;  ///< of those that have not reached their end
  std::vector<RunRecord> runs;         ///< one per seed
  std::vector<PooledQuantity> quantities;

  /// Of what its runs have found. @pre as many of one as of the other, one at least
  Ensemble(std::string directory, std::vector<std::uint64_t> seeds, std::vector<RunRecord> runs);
};

/// Whether a directory holds an ensemble.
bool is_ensemble(const std::string& directory);

/// From its ensemble.json and the folders of its members that have reached their end.
/// @throws InputError where that is damaged, or no member has
Ensemble read_ensemble(const std::string& directory);

/// Notes, for read_ensemble(), which members a directory has. @throws RunError
void write_members(const std::string& directory, const std::vector<std::uint64_t>& seeds);

/// As one of those that are compared: its quantities rest on the members' means. One that has a
/// single member is that run.
Compared compared(Ensemble&& ensemble);

/// What the ensemble tells: how sure the means are, whether single runs would have told it, whether
/// the window begins too early, and what it would take to know them to 5 %.
std::vector<std::string> sentences(const Ensemble& ensemble);

/// Quantities and sentences, as the page has them.
nlohmann::ordered_json to_json(const Ensemble& ensemble);

/// pooled.json: the quantities by name, with units as in summary.json.
nlohmann::ordered_json pooled_json(const Ensemble& ensemble);

}  // namespace washtub
