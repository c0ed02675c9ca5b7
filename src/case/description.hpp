#pragma once
#include <string>
#include <vector>

#include "case/case.hpp"

namespace washtub {

/// Something to know about a case or a run, in words: "grid", "32 x 32 x 32 cells".
struct Fact {
  std::string name;
  std::string value;  ///< with units
};

/// What a case means: grid, sides of the box, scales, solids, cloth, times.
std::vector<Fact> describe(const Case& whole);

/// "z no-slip below, slip above": conditions of the sides, axis by axis.
std::string sides_text(const Case& whole);

/// "turns at up to 120 rpm, period 1.571 s, 360 deg to and fro".
std::string drive_text(const Drive& drive);

}  // namespace washtub
