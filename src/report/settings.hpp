#pragma once
#include <string>
#include <vector>

#include "report/run_record.hpp"

namespace washtub {

/// Keys of case.toml in which runs differ, as sentences: "washer.agitator.fins: 3 in A, 4 in B".
/// The title does not count. One sentence says where nothing differs, or a case is missing.
std::vector<std::string> differing_settings(const std::vector<const RunRecord*>& runs);

}  // namespace washtub
