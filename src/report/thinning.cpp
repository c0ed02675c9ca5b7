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

bool too_coarse(const std::array<int, 3>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](int n) { return n > 1 && n < least_cells; });
}

std::string size_text(const std::array<int, 3>& cells) {
  return fmt::format("{}", fmt::join(cells.begin(), cells.end() - (cells[2] == 1), " x "));
}

}  // namespace

std::size_t kept(std::size_t frames, int every) {
  const auto step = static_cast<std::size_t>(every);
  return every == 0 ? 0 : (frames + step - 1) / step;
}

std::vector<Thinning> thinnings(std::size_t frames, const std::array<int, 3>& cells) {
  std::vector<Thinning> plans;
  if (cells[0] > 0 && frames > 0) {
    Thinning plan;
    plans.push_back(plan);
    while (plan.coarsenings < most_coarsenings &&
           !too_coarse(coarse_cells(cells, plan.coarsenings + 1))) {
      ++plan.coarsenings;
      plans.push_back(plan);
    }
    while (kept(frames, 2 * plan.water_every) >= least_water) {
      plan.water_every *= 2;
      plans.push_back(plan);
    }
  }
  Thinning plan{0, 0, 1};
  plans.push_back(plan);
  while (kept(frames, plan.frames_every) > 1) {
    plan.frames_every *= 2;
    plans.push_back(plan);
  }
  return plans;
}

std::vector<std::string> thinning_notes(const Thinning& thinning, std::size_t frames,
                                        const std::array<int, 3>& cells) {
  std::vector<std::string> notes;
  if (thinning.frames_every > 1)
    notes.push_back(
        fmt::format("{} of {} frames are shown.", kept(frames, thinning.frames_every), frames));
  if (cells[0] == 0 || frames == 0) return notes;
  if (thinning.water_every == 0) notes.push_back("The water is left out to keep the page small.");
  if (thinning.water_every > 1)
    notes.push_back(fmt::format("{} of {} frames carry the water.",
                                kept(frames, thinning.water_every), frames));
  if (thinning.coarsenings > 0)
    notes.push_back(fmt::format("The water is shown on {} of {} cells.",
                                size_text(coarse_cells(cells, thinning.coarsenings)),
                                size_text(cells)));
  return notes;
}

}  // namespace washtub
