#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "case/case.hpp"

namespace washtub {

/// "5": 1 to 5. "6-10": 6 to 10. @throws InputError for anything else, and fewer than two
std::vector<std::uint64_t> parse_seeds(const std::string& text);

/// What makes a case the s-th member of its ensemble, as settings "cloth[2].seed=7": the first has
/// the case's own seeds, and each next one those behind, so that no two groups of any members have
/// the same unless the case's own groups have. Where they all have 1, the member's are s.
/// @throws InputError where the case has no cloth, and where none of it is drawn at random
std::vector<std::string> member_settings(const Case& whole, std::uint64_t seed);

/// "seed-7"
std::string member_name(std::uint64_t seed);

}  // namespace washtub
