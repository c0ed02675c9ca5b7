#pragma once
#include <span>
#include <vector>

namespace washtub {

/// Of each of several runs the values of a quantity in its cycles, or other batches.
using Members = std::span<const std::vector<double>>;

/// How many neighbouring batches have to be taken together, 1, 2, 4 ..., until the means of
/// neighbouring blocks are not significantly correlated (one-sided at 5 %, all members together).
/// A few batches tell no correlation, so that of them each counts for itself.
std::size_t block_length(Members members);

/// Means of whole blocks of so many batches, the last one at the end; what is left over at the
/// begin does not count.
std::vector<double> blocks(std::span<const double> batches, std::size_t length);

/// The blocks of one run: values that count as independent.
std::vector<double> independent_blocks(const std::vector<double>& batches);

}  // namespace washtub
