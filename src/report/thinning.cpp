#include "report/thinning.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/fields.hpp"

namespace washtub {
namespace {

constexpr int least_cells = 16;
constexpr int most_coarsenings = 2;
constexpr std::size_t least_water = 4;  ///< frames that carry it
constexpr std::size_t least_rows = 100;

bool too_coarse(const std::array<int, 3>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](int n) { return n > 1 && n < least_cells; });
}

std::string size_text(const std::array<int, 3>& cells) {
  return fmt::format("{}", fmt::join(cells.begin(), cells.end() - (cells[2] == 1), " x "));
}

}  // namespace

std::vector<std::size_t> kept(std::size_t count, int every) {
  std::vector<std::size_t> numbers;
  if (count == 0 || every == 0) return numbers;
  for (std::size_t n = 0; n < count; n += static_cast<std::size_t>(every)) numbers.push_back(n);
  if (numbers.back() + 1 < count) numbers.push_back(count - 1);
  return numbers;
}

std::size_t row_count(const std::string& text) {
  const auto lines = static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  return lines > 0 ? lines - 1 : 0;
}

std::string thin_rows(const std::string& text, int every) {
  const std::size_t rows = row_count(text);
  if (every == 1 || rows == 0) return text;
  std::size_t begin = text.find('\n') + 1, row = 0;
  std::string thin = text.substr(0, begin);
  for (const std::size_t number : kept(rows, every))
    for (bool done = false; !done; ++row) {
      const std::size_t end = text.find('\n', begin) + 1;
      done = row == number;
      if (done) thin.append(text, begin, end - begin);
      begin = end;
    }
  return thin;
}

std::vector<Thinning> thinnings(const Amount& whole) {
  const std::size_t frames = whole.frames;
  const std::array<int, 3>& cells = whole.cells;
  std::vector<Thinning> plans;
  if (cells[0] > 0 && frames > 0) {
    Thinning plan;
    plans.push_back(plan);
    while (plan.coarsenings < most_coarsenings &&
           !too_coarse(coarse_cells(cells, plan.coarsenings + 1))) {
      ++plan.coarsenings;
      plans.push_back(plan);
    }
    while (kept(frames, 2 * plan.water_every).size() >= least_water) {
      plan.water_every *= 2;
      plans.push_back(plan);
    }
  }
  Thinning plan{0, 0, 1, 1, 1};
  plans.push_back(plan);
  while (kept(frames, plan.frames_every).size() > 2) {
    plan.frames_every *= 2;
    plans.push_back(plan);
  }
  const auto thin = [&](int Thinning::*every, std::size_t rows) {
    while (kept(rows, 2 * (plan.*every)).size() >= least_rows) {
      plan.*every *= 2;
      plans.push_back(plan);
    }
  };
  thin(&Thinning::tracks_every, whole.tracks);
  thin(&Thinning::history_every, whole.history);
  if (frames == 0) return plans;
  plan.frames_every = 0;
  plans.push_back(plan);
  return plans;
}

std::vector<std::string> thinning_notes(const Thinning& thinning, const Amount& whole) {
  const std::size_t frames = whole.frames;
  const std::array<int, 3>& cells = whole.cells;
  std::vector<std::string> notes;
  if (thinning.history_every > 1)
    notes.push_back(fmt::format("Curves: 1 of {} rows is kept.", thinning.history_every));
  if (thinning.tracks_every > 1)
    notes.push_back(
        fmt::format("Curves of the pieces: 1 of {} rows is kept.", thinning.tracks_every));
  if (frames == 0) return notes;
  if (thinning.frames_every == 0) {
    notes.emplace_back("The frames are left out to keep the page small.");
    return notes;
  }
  if (kept(frames, thinning.frames_every).size() < frames)
    notes.push_back(fmt::format("{} of {} frames are shown.",
                                kept(frames, thinning.frames_every).size(), frames));
  if (cells[0] == 0) return notes;
  if (thinning.water_every == 0)
    notes.emplace_back("The water is left out to keep the page small.");
  if (thinning.water_every > 1)
    notes.push_back(fmt::format("{} of {} frames carry the water.",
                                kept(frames, thinning.water_every).size(), frames));
  if (thinning.coarsenings > 0)
    notes.push_back(fmt::format("The water is shown on {} of {} cells.",
                                size_text(coarse_cells(cells, thinning.coarsenings)),
                                size_text(cells)));
  return notes;
}

}  // namespace washtub
