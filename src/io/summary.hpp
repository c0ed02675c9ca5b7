#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace washtub {

/// Writes summary.json, indented, keys in the order given; NaN and infinity become null.
/// @throws RunError with path and reason; an older file is then as it was
void write_summary(const std::string& path, const nlohmann::ordered_json& summary);

}  // namespace washtub
