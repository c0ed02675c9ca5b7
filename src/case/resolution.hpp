#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"

namespace washtub {

/// What the grid does not resolve, in words, with what would: solids thinner than two cells, and
/// gaps between solids, where they are at the start, narrower than the four cells that cloth takes
/// in the water.
std::vector<std::string> unresolved(const Case& whole);

}  // namespace washtub
