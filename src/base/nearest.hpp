#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace washtub {

/// Levenshtein's distance: single-letter insertions, deletions and replacements.
int edit_distance(std::string_view a, std::string_view b);

/// The known name most like `name`; "" where none is near (over half of its letters differ).
std::string nearest_name(const std::string& name, const std::vector<std::string>& known);

}  // namespace washtub
