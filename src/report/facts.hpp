#pragma once
#include <nlohmann/json.hpp>

#include "report/run_record.hpp"

namespace washtub {

/// What to know about a run as the page has it: name and value, with units, of the outcome, the
/// case, and what the run took.
nlohmann::ordered_json facts(const RunRecord& run);

/// Dimensionless groups of its case as the page has them: name, value, meaning.
nlohmann::ordered_json groups(const RunRecord& run);

}  // namespace washtub
