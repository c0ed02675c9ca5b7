#pragma once
#include <optional>
#include <set>

#include "case/case.hpp"
#include "io/xdmf.hpp"
#include "report/fields.hpp"
#include "report/frame_set.hpp"

namespace washtub {

/// The cells of a case's water in space, and where its box repeats itself.
struct WaterGrid {
  explicit WaterGrid(const Case& whole);

  FluidGrid grid;
  int dimension;
  std::array<bool, 2> periodic;
};

/// The water of a run's frames, read one at a time.
class Water {
 public:
  Water(const FrameSet& frames, const WaterGrid& grid) : frames_(frames), grid_(grid) {}

  /// None, and remembered as bad, where the file cannot be read.
  std::optional<Lattice> read(std::size_t frame, int coarsenings);

  /// How many bytes of a page a frame takes, from a few frames.
  double bytes_per_frame(int coarsenings);

  const FluidGrid& grid() const { return grid_.grid; }

  /// Numbers of the files that could not be read.
  const std::set<int>& bad() const { return bad_; }

 private:
  const FrameSet& frames_;
  WaterGrid grid_;
  std::set<int> bad_;
};

}  // namespace washtub
