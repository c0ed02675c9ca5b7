#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace washtub {

/// How much of a run's frames a page carries.
struct Thinning {
  int coarsenings = 0;   ///< of the water's cells, by 2 each
  int water_every = 1;   ///< every so many-th frame carries the water; 0: none does
  int frames_every = 1;  ///< every so many-th frame is shown
};

/// From everything to the least, in the order in which a page is thinned: coarser water, down to 16
/// cells along an edge; water in fewer frames; no water; fewer frames. `cells` of the water, 0
/// where there is none.
std::vector<Thinning> thinnings(std::size_t frames, const std::array<int, 3>& cells);

/// How many of `frames` are kept where every so many-th is.
std::size_t kept(std::size_t frames, int every);

/// What was left out, in sentences; none where nothing was.
std::vector<std::string> thinning_notes(const Thinning& thinning, std::size_t frames,
                                        const std::array<int, 3>& cells);

}  // namespace washtub
