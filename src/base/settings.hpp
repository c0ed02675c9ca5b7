#pragma once
#include <string>
#include <utility>
#include <vector>

#include "base/document.hpp"

namespace washtub {

/// Settings of a case in the order of its file: dotted key and value.
using Settings = std::vector<std::pair<std::string, std::string>>;

Settings settings_of(const Node& root);

/// Sentences such as `fluid.viscosity = "1 Pa s", here "2 Pa s"` for every key in which the
/// settings `there` differ from those `here`.
std::vector<std::string> differences(const Settings& there, const Settings& here);

}  // namespace washtub
