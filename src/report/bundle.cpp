#include "report/bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "case/groups.hpp"
#include "report/columns_index.hpp"
#include "report/facts.hpp"
#include "report/frames_index.hpp"
#include "report/json.hpp"
#include "report/statistics.hpp"
#include "report/surface.hpp"
#include "report/thinning.hpp"
#include "report/warnings.hpp"
#include "washer/build.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

Json scales_index(const std::optional<Case>& definition) {
  if (!definition) return {{"stress", 0}, {"torque", 0}, {"length", 0}, {"period", 0}};
  const auto scale = scales(*definition);
  return {{"stress", scale ? scale->stress : 0},
          {"torque", scale ? scale->torque : 0},
          {"length", definition->scale.length},
          {"period", definition->scale.period}};
}

Json window_index(const RunRecord& run) {
  if (!run.definition) return {0, 0};
  return {run.definition->output.window_begin, run.definition->output.window_end};
}

/// What the statistics rest on.
Json averaged_index(const RunRecord& run) {
  if (!run.definition || !run.history) return {0, 0};
  const Interval over = WindowedHistory(*run.definition, *run.history).averaging().over;
  return {over.begin, over.end};
}

/// The case's box, in plane cases the slab of its cells; around the cloth where there is no case.
SurfaceBox case_box(const std::optional<Case>& definition, const FrameSet& frames) {
  if (!definition) {
    const auto [lower, upper] = cloth_span(frames, kept(frames.size(), 1));
    return {lower, upper};
  }
  const FluidGrid grid = WaterGrid(*definition).grid;
  const Vec<3> cells(grid.cells[0], grid.cells[1], grid.cells[2]);
  return {grid.lower, grid.lower + cells.cwiseProduct(grid.spacing), definition->dimension == 2};
}

bool has_free_surface(const Case& whole) {
  const auto& sides = whole.domain.sides;
  return whole.dimension == 3 && sides[5].kind == SideKind::slip && sides[4].kind != SideKind::slip;
}

Json solids_index(const Case& whole, const SurfaceBox& box, Chunks& chunks,
                  std::vector<std::string>& notes) {
  Json solids = Json::array();
  for (const Solid& solid : build_solids(whole)) {
    const auto seen = surface(solid, box);
    if (!seen && reaches_into(solid, box))
      notes.push_back(fmt::format("{} is not shown: it is too thin to be drawn.", solid.name));
    if (!seen) continue;
    solids.push_back({{"name", solid.name},
                      {"moving", solid.drive.moving()},
                      {"centre", triple(solid.centre)},
                      {"vertices", chunks.add(seen->vertices)},
                      {"triangles", chunks.add(seen->triangles)}});
  }
  return solids;
}

/// Name and number of pieces of each group of cloth; one group where the case does not tell.
Json groups_index(const RunRecord& run, std::size_t pieces) {
  Json groups = Json::array();
  std::size_t told = 0;
  if (run.definition)
    for (const ClothCase& cloth : run.definition->cloth) {
      if (cloth.count == 0) continue;
      groups.push_back({{"name", cloth.name}, {"pieces", cloth.count}});
      told += static_cast<std::size_t>(cloth.count);
    }
  if (told == pieces) return groups;
  return Json::array({{{"name", "cloth"}, {"pieces", pieces}}});
}

Json cloth_index(const RunRecord& run, const FrameSet& frames) {
  if (frames.pieces.empty()) return nullptr;
  Json pieces = Json::array();
  for (const auto& p : frames.pieces)
    pieces.push_back({{"first", p.first},
                      {"nr", p.extent[0]},
                      {"ns", p.extent[1]},
                      {"closed", {p.closed[0], p.closed[1]}}});
  return {{"pieces", pieces},
          {"groups", groups_index(run, frames.pieces.size())},
          {"nodes", frames.nodes}};
}

/// The rows of a table that are kept.
Json rows_chunk(const std::string& text, int every, Chunks& chunks) {
  return text.empty() ? Json(nullptr) : Json(chunks.add(thin_rows(text, every)));
}

/// All but the curves and the frames.
Json head(const RunRecord& run, const FrameSet& frames, Chunks& chunks,
          std::vector<std::string>& notes) {
  const SurfaceBox whole = case_box(run.definition, frames);
  Json index = {{"name", run.name}, {"directory", run.directory}};
  index["title"] = run.definition ? run.definition->title : run.name;
  index["dimension"] = dimension(run);
  index["outcome"] = outcome(run);
  index["facts"] = facts(run);
  index["groups"] = groups(run);
  index["warnings"] = warnings(run);
  index["quantities"] = quantities(run);
  index["columns"] = run.history ? columns_index(*run.history) : Json::array();
  index["scales"] = scales_index(run.definition);
  index["window"] = window_index(run);
  index["averaged"] = averaged_index(run);
  index["case"] = run.case_text;
  index["box"] = {{"lower", triple(whole.lower)}, {"upper", triple(whole.upper)}};
  index["free_surface"] = run.definition && has_free_surface(*run.definition);
  index["solids"] =
      run.definition ? solids_index(*run.definition, whole, chunks, notes) : Json::array();
  index["cloth"] = cloth_index(run, frames);
  return index;
}

/// What is missing, whatever the size of the page.
std::vector<std::string> notes(const RunRecord& run, const FrameSet& frames) {
  std::vector<std::string> all = run.missing;
  all.insert(all.end(), frames.notes.begin(), frames.notes.end());
  if (frames.size() > 0) return all;
  const bool none_wanted = run.definition && run.definition->output.frames <= 0;
  all.push_back(none_wanted ? "There is nothing to look at but curves: output.frames is 0 in the "
                              "case, so that the run wrote no frames."
                            : "There are no frames yet, only curves.");
  return all;
}

/// The water, if its frames have the case's cells.
std::optional<Water> find_water(const RunRecord& run, const FrameSet& frames,
                                std::vector<std::string>& notes) {
  if (!run.definition || frames.size() == 0) return {};
  const WaterGrid grid(*run.definition);
  if (grid.grid.cells == frames.cells) return Water(frames, grid);
  notes.push_back("The water is not shown: the frames have other cells than case.toml.");
  return {};
}

/// A sentence on water that could not be read; "" where all could.
std::string bad_water(const std::optional<Water>& water) {
  if (!water || water->bad().empty()) return "";
  const std::vector<int> bad(water->bad().begin(), water->bad().end());
  return fmt::format("The water of {} could not be read.", frame_list(bad));
}

/// Angles of solids at rest tell nothing.
void drop_resting(const RunRecord& run, Json& angles) {
  if (!run.definition) return;
  for (const SolidCase& solid : run.definition->solids)
    if (!solid.drive.moving()) angles.erase(solid.name);
}

/// Bytes that a text takes in a page.
double deflated_size(const std::string& text) {
  Chunks chunks;
  if (!text.empty()) chunks.add(text);
  return static_cast<double>(chunks.size());
}

/// About how much of a page a thinned run takes, found without making it.
class Estimate {
 public:
  Estimate(const RunRecord& run, const FrameSet& frames, std::optional<Water>& water)
      : tracks_(deflated_size(run.tracks_text)),
        history_(deflated_size(run.history_text)),
        frames_(frames, water) {}
  double bytes(const Thinning& plan) {
    return tracks_ / plan.tracks_every + history_ / plan.history_every + frames_.bytes(plan);
  }

 private:
  double tracks_, history_;
  FrameEstimate frames_;
};

/// A run that is made into one page part after another until it is small enough.
class Bundler {
 public:
  Bundler(const RunRecord& run, Chunks& chunks)
      : run_(run),
        chunks_(chunks),
        before_(chunks.size()),
        frames_(read_frames(run.directory)),
        known_(notes(run, frames_)) {
    out_.index = head(run, frames_, chunks, known_);
    if (auto water = find_water(run, frames_, known_)) water_.emplace(std::move(*water));
    own_ = chunks.texts().size();
    whole_ = {frames_.size(), water_ ? frames_.cells : std::array<int, 3>{},
              row_count(run.tracks_text), row_count(run.history_text)};
  }

  RunBundle fit(std::size_t room) {
    const double free = static_cast<double>(room) - static_cast<double>(used());
    const std::vector<Thinning> plans = thinnings(whole_);
    std::optional<Estimate> estimate;
    for (const Thinning& plan : plans) {
      const bool last = &plan == &plans.back();
      if (!last && free <= 0) continue;
      if (!estimate && !last) estimate.emplace(run_, frames_, water_);
      // The estimate may be a little too high.
      if (!last && 0.95 * estimate->bytes(plan) > free) continue;
      make(plan);
      if (out_.bytes <= room) break;
    }
    return std::move(out_);
  }

 private:
  void make(const Thinning& plan) {
    chunks_.shrink(own_);
    Json& index = out_.index;
    index["history"] = rows_chunk(run_.history_text, plan.history_every, chunks_);
    index["tracks"] = rows_chunk(run_.tracks_text, plan.tracks_every, chunks_);
    index["frames"] = frames_index(frames_, water_, plan, chunks_);
    drop_resting(run_, index["frames"]["angles"]);
    out_.notes = known_;
    for (const std::string& note : thinning_notes(plan, whole_)) out_.notes.push_back(note);
    if (const std::string bad = bad_water(water_); !bad.empty()) out_.notes.push_back(bad);
    index["notes"] = out_.notes;
    out_.bytes = used();
    out_.frames = kept(frames_.size(), plan.frames_every).size();
  }

  /// Bytes of a page that the index and the chunks of this run take.
  std::size_t used() const { return chunks_.size() - before_ + page_json(out_.index).size(); }

  const RunRecord& run_;
  Chunks& chunks_;
  std::size_t before_;
  FrameSet frames_;
  std::vector<std::string> known_;
  std::optional<Water> water_;
  std::size_t own_ = 0;
  Amount whole_;
  RunBundle out_;
};

}  // namespace

RunBundle bundle(const RunRecord& run, Chunks& chunks, std::size_t room) {
  return Bundler(run, chunks).fit(room);
}

}  // namespace washtub
