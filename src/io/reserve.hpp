#pragma once
#include <cstddef>
#include <string>

#include "base/parallel.hpp"

namespace washtub {

/// Makes the temporary PATH.part where it is missing, and room for `bytes` of it on the disk, since
/// the parallel library does not survive a write that fails (collective). To be called before it
/// makes the file, which may give the room away, and after.
/// @throws RunError with path and reason, on all ranks; then the temporary is gone
void reserve_file(const std::string& path, std::size_t bytes, const Parallel& parallel);

}  // namespace washtub
