#pragma once
#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace washtub {

/// What there is to thin.
struct Amount {
  std::size_t frames = 0;
  std::array<int, 3> cells{};  ///< of the water, 0 where there is none
  std::size_t tracks = 0;      ///< rows of tracks.csv
  std::size_t history = 0;     ///< rows of history.csv
};

/// How much of a run a page carries. The first and the last one of frames and rows always stay.
struct Thinning {
  int coarsenings = 0;    ///< of the water's cells, by 2 each
  int water_every = 1;    ///< every so many-th frame carries the water; 0: none does
  int frames_every = 1;   ///< every so many-th frame is shown; 0: none is
  int tracks_every = 1;   ///< every so many-th row of tracks.csv is kept
  int history_every = 1;  ///< the same for history.csv
};

/// From everything to the least, in the order in which a page is thinned: coarser water, down to 16
/// cells along an edge; water in fewer frames; no water; fewer frames; fewer rows of the tracks,
/// then of the history, down to 100; no frames.
std::vector<Thinning> thinnings(const Amount& whole);

/// Which of `count` are kept where every so many-th one and the last are; none for 0.
std::vector<std::size_t> kept(std::size_t count, int every);

/// The lines of a CSV file that are kept: the header and such rows. All lines have an end.
std::string thin_rows(const std::string& text, int every);
std::size_t row_count(const std::string& text);

/// What was left out, in sentences; none where nothing was.
std::vector<std::string> thinning_notes(const Thinning& thinning, const Amount& whole);

}  // namespace washtub
