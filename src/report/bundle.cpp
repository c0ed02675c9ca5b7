#include "report/bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "report/facts.hpp"
#include "report/frames_index.hpp"
#include "report/quantities.hpp"
#include "report/surface.hpp"
#include "report/thinning.hpp"
#include "report/warnings.hpp"
#include "washer/build.hpp"
#include "washer/groups.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

Json triple(const Vec<3>& x) { return {x.x(), x.y(), x.z()}; }

Json scales_index(const std::optional<Case>& definition) {
  if (!definition) return {{"stress", 0}, {"torque", 0}, {"length", 0}, {"period", 0}};
  const Scales scale = scales(*definition);
  const bool any = definition->scale.speed > 0 && definition->scale.length > 0;
  return {{"stress", any ? scale.stress : 0},
          {"torque", any ? scale.torque : 0},
          {"length", definition->scale.length},
          {"period", definition->scale.period}};
}

Json window_index(const RunRecord& run) {
  if (!run.definition) return {0, 0};
  return {run.definition->output.window_begin, run.definition->output.window_end};
}

/// The case's box, in plane cases the slab of its cells; around the cloth where there is no case.
SurfaceBox case_box(const std::optional<Case>& definition, const FrameSet& frames) {
  if (!definition) {
    const auto [lower, upper] = cloth_span(frames, 1);
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

Json solids_index(const Case& whole, const SurfaceBox& box, Chunks& chunks) {
  Json solids = Json::array();
  for (const Solid& solid : build_solids(whole)) {
    const auto seen = surface(solid, box);
    if (!seen) continue;
    solids.push_back({{"name", solid.name},
                      {"moving", solid.drive.moving()},
                      {"centre", triple(solid.centre)},
                      {"vertices", chunks.add(seen->vertices)},
                      {"triangles", chunks.add(seen->triangles)}});
  }
  return solids;
}

Json cloth_index(const FrameSet& frames) {
  if (frames.pieces.empty()) return nullptr;
  Json pieces = Json::array();
  for (const auto& p : frames.pieces)
    pieces.push_back({{"first", p.first},
                      {"nr", p.extent[0]},
                      {"ns", p.extent[1]},
                      {"closed", {p.closed[0], p.closed[1]}}});
  return {{"pieces", pieces}, {"nodes", frames.nodes}};
}

Json text_chunk(const std::string& text, Chunks& chunks) {
  return text.empty() ? Json(nullptr) : Json(chunks.add(text));
}

/// All but the frames.
Json head(const RunRecord& run, const FrameSet& frames, Chunks& chunks) {
  const SurfaceBox whole = case_box(run.definition, frames);
  Json index = {{"name", run.name}, {"directory", run.directory}};
  index["title"] = run.definition ? run.definition->title : run.name;
  index["dimension"] = dimension(run);
  index["outcome"] = outcome(run);
  index["facts"] = facts(run);
  index["groups"] = groups(run);
  index["warnings"] = warnings(run);
  index["quantities"] = quantities(run);
  index["scales"] = scales_index(run.definition);
  index["window"] = window_index(run);
  index["case"] = run.case_text;
  index["history"] = text_chunk(run.history_text, chunks);
  index["tracks"] = text_chunk(run.tracks_text, chunks);
  index["box"] = {{"lower", triple(whole.lower)}, {"upper", triple(whole.upper)}};
  index["free_surface"] = run.definition && has_free_surface(*run.definition);
  index["solids"] = run.definition ? solids_index(*run.definition, whole, chunks) : Json::array();
  index["cloth"] = cloth_index(frames);
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

std::vector<std::string> with_thinning(const std::vector<std::string>& known, const Thinning& plan,
                                       const FrameSet& frames, const std::optional<Water>& water) {
  std::vector<std::string> all = known;
  const auto cells = water ? frames.cells : std::array<int, 3>{};
  for (const std::string& note : thinning_notes(plan, frames.size(), cells)) all.push_back(note);
  if (!water || water->bad().empty()) return all;
  const std::vector<int> bad(water->bad().begin(), water->bad().end());
  all.push_back(fmt::format("The water of {} could not be read.", frame_list(bad)));
  return all;
}

/// Angles of solids at rest tell nothing.
void drop_resting(const RunRecord& run, Json& angles) {
  if (!run.definition) return;
  for (const SolidCase& solid : run.definition->solids)
    if (!solid.drive.moving()) angles.erase(solid.name);
}

/// Bytes of a page that the index and the chunks since `before` take.
std::size_t used(const Json& index, const Chunks& chunks, std::size_t before) {
  return chunks.size() - before + page_json(index).size();
}

}  // namespace

std::string page_json(const Json& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, Json::error_handler_t::replace))
    if (c == '<')
      text += "\\u003c";
    else
      text += c;
  return text;
}

RunBundle bundle(const RunRecord& run, Chunks& chunks, std::size_t room) {
  const FrameSet frames = read_frames(run.directory);
  const std::size_t before = chunks.size();
  RunBundle out{head(run, frames, chunks), 0, 0};
  std::vector<std::string> known = notes(run, frames);
  std::optional<Water> water = find_water(run, frames, known);
  const std::size_t own = chunks.texts().size();
  const double free =
      static_cast<double>(room) - static_cast<double>(used(out.index, chunks, before));
  const std::array<int, 3> cells = water ? frames.cells : std::array<int, 3>{};
  FrameEstimate estimate(frames, water);
  const std::vector<Thinning> plans = thinnings(frames.size(), cells);
  for (const Thinning& plan : plans) {
    const bool last = &plan == &plans.back();
    // The estimate may be a little too high.
    if (!last && 0.95 * estimate.bytes(plan) > free) continue;
    chunks.shrink(own);
    out.index["frames"] = frames_index(frames, water, plan, chunks);
    drop_resting(run, out.index["frames"]["angles"]);
    out.index["notes"] = with_thinning(known, plan, frames, water);
    out.bytes = used(out.index, chunks, before);
    out.frames = kept(frames.size(), plan.frames_every);
    if (out.bytes <= room) break;
  }
  return out;
}

}  // namespace washtub
