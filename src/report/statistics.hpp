#pragma once
#include <nlohmann/json.hpp>
#include <vector>

#include "record/quantities.hpp"
#include "report/run_record.hpp"

namespace washtub {

/// From history.csv those of the cloth and of every solid, whose name comes first: "agitator rms
/// torque". From the summary: the scatter of the cloth. All of them are left out where the window
/// is not known.
std::vector<RunQuantity> find_quantities(const RunRecord& run);

/// As the page has it.
nlohmann::ordered_json to_json(const RunQuantity& quantity);

/// All of them, as the page has them.
nlohmann::ordered_json quantities(const RunRecord& run);

}  // namespace washtub
