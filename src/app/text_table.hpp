#pragma once
#include <string>
#include <vector>

namespace washtub {

using TextRow = std::vector<std::string>;

/// Prints rows of as many cells each, in columns.
void print(const std::vector<TextRow>& table);

}  // namespace washtub
