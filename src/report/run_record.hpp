#pragma once
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "case/case.hpp"
#include "io/table.hpp"

namespace washtub {

/// What an output directory holds, but for its frames. A run may still be going on, have failed, or
/// be of another version: then parts are missing, and `missing` says so in sentences.
struct RunRecord {
  std::string directory, name;            ///< as given; the last part of the path
  std::optional<Case> definition;         ///< from case.toml; none where it is missing or wrong
  std::string case_text;                  ///< case.toml as it is; "" where missing
  nlohmann::ordered_json summary;         ///< null where there is none
  std::optional<CsvTable> history;        ///< none where it is missing or wrong
  std::optional<CsvTable> tracks;         ///< of the pieces; none where there is no cloth either
  std::string history_text, tracks_text;  ///< their sound rows as they are; "" where missing
  std::vector<std::string> missing;       ///< sentences on what is missing or wrong
};

/// @throws InputError where the directory is no output of washtub
RunRecord read_run(const std::string& directory);

/// "complete", "stopped", the error that ended the run, or "unfinished" without a summary.
std::string outcome(const RunRecord& run);

/// 2 or 3; without a case from the units of the history; none without either.
std::optional<int> known_dimension(const RunRecord& run);
/// The same, 3 where it is not known.
int dimension(const RunRecord& run);

/// A number of the summary by the names that lead to it; none where it is not there.
std::optional<double> summary_number(const RunRecord& run, const std::vector<std::string>& names);
/// The same for a list of numbers; empty where it is not there.
std::vector<double> summary_numbers(const RunRecord& run, const std::vector<std::string>& names);

}  // namespace washtub
