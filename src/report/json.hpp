#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "base/vec.hpp"

namespace washtub {

/// JSON as it may stand in a page: '<' escaped.
std::string page_json(const nlohmann::ordered_json& json);

/// A Vec3 of viewer/src/model/bundle.ts.
nlohmann::ordered_json triple(const Vec<3>& x);

}  // namespace washtub
