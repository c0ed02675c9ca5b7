#include "report/field_stream.hpp"

#include <algorithm>
#include <cmath>

#include "report/quantise.hpp"

namespace washtub {

using Json = nlohmann::ordered_json;

void FieldStream::Companded::add(const std::vector<float>& frame) {
  const double scale = largest_magnitude(frame);
  std::vector<std::int8_t> small;
  small.reserve(frame.size());
  for (const float v : frame) small.push_back(quantise_companded(v, scale));
  values.add(std::span<const std::int8_t>(small));
  largest.push_back(scale);
}

Json FieldStream::Companded::finish(Chunks& chunks) {
  return {{"values", chunks.add(values)}, {"largest", largest}};
}

void FieldStream::add(std::size_t frame, const Lattice& water) {
  frames_.push_back(frame);
  velocity_.add(water.velocity);
  plane_ = !water.vorticity.empty();
  if (plane_) vorticity_.add(water.vorticity);
  add_scalars(water);
  std::vector<std::uint8_t> solid;
  solid.reserve(water.size());
  for (const float s : water.solid)
    solid.push_back(static_cast<std::uint8_t>(std::lround(255 * (s >= 0 ? std::min(s, 1.F) : 0))));
  solid_.add(std::span<const std::uint8_t>(solid));
}

void FieldStream::add_scalars(const Lattice& water) {
  if (frames_.size() == 1)
    for (const auto& one : water.scalars) scalars_.emplace_back(one.field);
  for (Scalar& scalar : scalars_) {
    const auto* values = find(water.scalars, scalar.field.name);
    scalar.stream.add(values ? *values : std::vector<float>(water.size(), 0));
  }
}

Json FieldStream::finish(Chunks& chunks) {
  Json index = {{"frames", frames_}, {"velocity", velocity_.finish(chunks)}};
  index["vorticity"] = plane_ ? vorticity_.finish(chunks) : Json(nullptr);
  index["solid"] = chunks.add(solid_);
  index["scalars"] = Json::array();
  for (auto& [field, stream] : scalars_) {
    Json scalar = stream.finish(chunks);
    scalar["name"] = field.name;
    scalar["label"] = field.label;
    scalar["unit"] = field.unit;
    scalar["meaning"] = field.meaning;
    index["scalars"].push_back(std::move(scalar));
  }
  return index;
}

}  // namespace washtub
