#pragma once
#include <vector>

#include "grid/grid.hpp"

namespace washtub {

/// Assembles a level that every rank holds whole from the parts the ranks computed.
template <int D>
class GatherBlocks {
 public:
  /// `part`: cells of this rank on the gathered level.
  GatherBlocks(const Parallel& parallel, const Block<D>& part);

  /// On return every rank's `array` (laid out as `whole`) holds all parts.
  void all(float* array, const Block<D>& whole);

 private:
  template <class Copy>
  void for_rows(int rank, const Block<D>& whole, Copy&& copy) const;

  Parallel parallel_;
  std::vector<int> boxes_;  ///< offset and count of every rank
  std::vector<int> sizes_, starts_;
  std::vector<float> packed_;
};

}  // namespace washtub
