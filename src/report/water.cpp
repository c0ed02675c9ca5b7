#include "report/water.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "report/field_stream.hpp"
#include "washer/build.hpp"

namespace washtub {

WaterGrid::WaterGrid(const Case& whole)
    : grid(whole.dimension == 3 ? fluid_grid(build_mesh<3>(whole))
                                : fluid_grid(build_mesh<2>(whole))),
      dimension(whole.dimension) {
  for (std::size_t d = 0; d < 2; ++d)
    periodic[d] = whole.domain.sides[2 * d].kind == SideKind::periodic;
}

std::optional<Lattice> Water::read(std::size_t frame, int coarsenings) {
  const int number = frames_.numbers[frame];
  if (bad_.contains(number)) return {};
  try {
    const FrameReader file(frame_path(frames_.directory, number));
    Lattice water = lattice(file.water(), grid_.dimension, grid_.grid.spacing, grid_.periodic);
    for (int c = 0; c < coarsenings; ++c) water = coarsen(water);
    return water;
  } catch (const InputError&) {
    bad_.insert(number);
    return {};
  }
}

double Water::bytes_per_frame(int coarsenings) {
  const std::size_t step = (frames_.size() + 3) / 4;
  FieldStream stream;
  for (std::size_t f = step / 2; f < frames_.size(); f += step)
    if (const auto water = read(f, coarsenings)) stream.add(f, *water);
  Chunks chunks;
  const auto index = stream.finish(chunks);
  return static_cast<double>(chunks.size()) /
         static_cast<double>(std::max<std::size_t>(stream.frames(), 1));
}

}  // namespace washtub
