#pragma once
#include <regex>
#include <vector>

#include "base/parallel.hpp"
#include "speed/results.hpp"

namespace washtub {

/// Times a triad of long vectors, the kernels of a step and whole steps, of the reference wash in
/// space and in the plane, all ranks together (collective). Takes about half a minute.
/// `filter`: only what a part of whose name matches.
std::vector<Speed> measure_speeds(const Parallel& parallel, const std::regex& filter);

}  // namespace washtub
