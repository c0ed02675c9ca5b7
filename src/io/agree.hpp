#pragma once
#include <string>

#include "base/parallel.hpp"

namespace washtub {

/// On return no rank has a reason to stop; else all throw, with the lowest such rank's reason
/// (collective). @throws RunError
void agree(const Parallel& parallel, const std::string& reason);

/// The same text on all ranks: that of rank 0 (collective).
std::string from_root(const Parallel& parallel, std::string text);

}  // namespace washtub
