#pragma once
#include <nlohmann/json.hpp>

#include "report/run_record.hpp"

namespace washtub {

/// What to mind about a run, in sentences with the measured value and the threshold; empty where
/// there is nothing. From the summary over all steps, without one from the samples of the history.
nlohmann::ordered_json warnings(const RunRecord& run);

}  // namespace washtub
