#pragma once
#include <string>

#include "case/case.hpp"
#include "cloth/worst_edge.hpp"

namespace washtub {

/// Why a run stops whose cloth is strained beyond `coupling.strain_limit`, where, and what helps.
std::string overstrained(const WorstEdge& edge, const Case& whole);

}  // namespace washtub
