#include "report/frames_index.hpp"

#include <algorithm>

#include "record/declared.hpp"
#include "report/field_stream.hpp"
#include "report/json.hpp"
#include "report/quantise.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

using Numbers = std::vector<std::size_t>;

Json positions_index(const FrameSet& frames, const Numbers& shown,
                     const std::array<Vec<3>, 2>& span, Chunks& chunks) {
  if (frames.nodes == 0 || shown.empty()) return nullptr;
  Deflater values;
  std::vector<std::uint16_t> small(3 * frames.nodes);
  for (const std::size_t f : shown) {
    for (std::size_t i = 0; i < small.size(); ++i) {
      const auto d = static_cast<Eigen::Index>(i / frames.nodes);
      small[i] = quantise_linear(frames.positions[f][i], span[0][d], span[1][d]);
    }
    values.add(std::span<const std::uint16_t>(small));
  }
  return chunks.add(values);
}

Json stress_index(const FrameSet::NodeField& field, const Numbers& shown, Chunks& chunks) {
  const auto& stress = field.values;
  double largest = 0;
  for (const std::size_t f : shown) largest = std::max(largest, largest_magnitude(stress[f]));
  Deflater values;
  for (const std::size_t f : shown) {
    std::vector<std::uint16_t> small;
    for (const float s : stress[f]) small.push_back(quantise_root(s, largest));
    values.add(std::span<const std::uint16_t>(small));
  }
  return {{"label", field.field.label}, {"values", chunks.add(values)}, {"largest", largest}};
}

/// Times, angles and cloth of the frames shown.
Json cloth_frames(const FrameSet& frames, const Numbers& shown, Chunks& chunks) {
  const auto thin = [&](const std::vector<double>& values) {
    Json thinned = Json::array();
    for (const std::size_t f : shown) thinned.push_back(values[f]);
    return thinned;
  };
  Json index = {{"times", thin(frames.times)}, {"angles", Json::object()}};
  for (const auto& [name, angles] : frames.angles) index["angles"][name] = thin(angles);
  const auto span = cloth_span(frames, shown);
  index["positions"] = positions_index(frames, shown, span, chunks);
  index["span"] = {{"lower", triple(span[0])}, {"upper", triple(span[1])}};
  index["stress"] = nullptr;
  if (frames.nodes > 0 && !shown.empty())
    for (const auto& one : frames.fields)
      if (one.field.unit == pascal.name)
        index["stress"][one.field.name] = stress_index(one, shown, chunks);
  return index;
}

Json fields_index(const FrameSet& frames, Water& water, const Thinning& thinning, Chunks& chunks) {
  FieldStream stream;
  for (const std::size_t f : kept(frames.size(), thinning.water_every))
    if (const auto lattice = water.read(f, thinning.coarsenings)) stream.add(f, *lattice);
  if (stream.frames() == 0) return nullptr;
  const FluidGrid& grid = water.grid();
  const auto cells = coarse_cells(grid.cells, thinning.coarsenings);
  Vec<3> spacing = grid.spacing;
  for (std::size_t d = 0; d < 3; ++d)
    if (grid.cells[d] > 1) spacing[static_cast<Eigen::Index>(d)] *= 1 << thinning.coarsenings;
  Json index = stream.finish(chunks);
  index["cells"] = cells;
  index["lower"] = triple(grid.lower);
  index["spacing"] = triple(spacing);
  return index;
}

}  // namespace

Json frames_index(const FrameSet& frames, std::optional<Water>& water, const Thinning& thinning,
                  Chunks& chunks) {
  Json index = cloth_frames(frames, kept(frames.size(), thinning.frames_every), chunks);
  index["fields"] = nullptr;
  if (water && thinning.water_every > 0)
    index["fields"] = fields_index(frames, *water, thinning, chunks);
  return index;
}

FrameEstimate::FrameEstimate(const FrameSet& frames, std::optional<Water>& water)
    : frames_(frames.size()), water_(water) {
  Chunks chunks;
  const Json index = cloth_frames(frames, kept(frames_, 1), chunks);
  cloth_ = static_cast<double>(chunks.size() + index.dump().size());
}

double FrameEstimate::bytes(const Thinning& thinning) {
  const double all = static_cast<double>(std::max<std::size_t>(frames_, 1));
  const double share = static_cast<double>(kept(frames_, thinning.frames_every).size()) / all;
  if (!water_ || thinning.water_every == 0) return share * cloth_;
  const int c = thinning.coarsenings;
  if (!water_each_.contains(c)) water_each_[c] = water_->bytes_per_frame(c);
  return share * cloth_ +
         water_each_[c] * static_cast<double>(kept(frames_, thinning.water_every).size());
}

}  // namespace washtub
