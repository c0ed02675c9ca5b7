#pragma once
#include <optional>
#include <string>

#include "case/case.hpp"

namespace washtub {

/// How many ranks a run takes.
struct RankChoice {
  int ranks = 1;
  std::string note = {};  ///< why they are fewer than the cores; "" = they are not
};

/// The number asked for; without one a rank for each free core, as far as the grid can be cut.
/// @throws InputError where the grid cannot be cut for so many
RankChoice choose_ranks(std::optional<int> asked, const Case& whole);

}  // namespace washtub
