#include "report/frame_set.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace washtub {
namespace {

std::vector<float> as_float(const std::vector<double>& values) {
  return {values.begin(), values.end()};
}

/// From x y z per node to all x, all y, all z.
std::vector<float> by_axis(const std::vector<double>& positions) {
  const std::size_t nodes = positions.size() / 3;
  std::vector<float> out;
  out.reserve(positions.size());
  for (std::size_t d = 0; d < 3; ++d)
    for (std::size_t n = 0; n < nodes; ++n) out.push_back(static_cast<float>(positions[3 * n + d]));
  return out;
}

/// @throws InputError if the frame is not shaped like those before it
void check_shape(const FrameSet& set, const std::string& path, const ClothFrame& cloth,
                 const std::array<int, 3>& cells, const std::vector<SolidAngle>& solids) {
  if (set.size() == 0) return;
  if (cells != set.cells)
    throw InputError(fmt::format("{}: has {} cells where the first frame has {}", path,
                                 fmt::join(cells, " x "), fmt::join(set.cells, " x ")));
  const auto same = [](const FrameSet::NodeField& known, const FieldValues<double>& one) {
    return known.field.name == one.field.name;
  };
  if (!std::equal(set.fields.begin(), set.fields.end(), cloth.fields.begin(), cloth.fields.end(),
                  same))
    throw InputError(
        fmt::format("{}: its cloth has other fields than that of the first frame", path));
  if (cloth.pieces != set.pieces)
    throw InputError(fmt::format("{}: its cloth is not that of the first frame", path));
  for (const SolidAngle& solid : solids)
    if (!set.angles.contains(solid.name))
      throw InputError(fmt::format("{}: its solids are not those of the first frame", path));
  if (solids.size() != set.angles.size())
    throw InputError(fmt::format("{}: its solids are not those of the first frame", path));
}

/// @throws InputError where cloth has flown off to nowhere
void check_finite(const std::string& path, const ClothFrame& cloth) {
  for (const double x : cloth.positions)
    if (!std::isfinite(static_cast<float>(x)))
      throw InputError(fmt::format("{}: its cloth is at places that are not finite", path));
}

void add(FrameSet& set, int number) {
  const std::string path = frame_path(set.directory, number);
  const FrameReader file(path);
  const double time = file.time();
  const std::vector<SolidAngle> solids = file.solids();
  const ClothFrame cloth = file.cloth();
  const std::array<int, 3> cells = file.cells();
  check_shape(set, path, cloth, cells, solids);
  check_finite(path, cloth);
  set.cells = cells;
  set.pieces = cloth.pieces;
  set.nodes = cloth.nodes();
  set.numbers.push_back(number);
  set.times.push_back(time);
  for (const SolidAngle& solid : solids) set.angles[solid.name].push_back(solid.angle);
  set.positions.push_back(by_axis(cloth.positions));
  if (set.size() == 1)
    for (const auto& one : cloth.fields) set.fields.push_back({one.field, {}});
  for (std::size_t f = 0; f < set.fields.size(); ++f)
    set.fields[f].values.push_back(as_float(cloth.fields[f].values));
}

/// "frames 2, 4 to 7 and 3 gaps more"
std::string gap_list(const std::vector<FrameGap>& gaps) {
  constexpr std::size_t most = 5;
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < std::min(most, gaps.size()); ++i)
    texts.push_back(gaps[i].first == gaps[i].last
                        ? std::to_string(gaps[i].first)
                        : fmt::format("{} to {}", gaps[i].first, gaps[i].last));
  const bool one = gaps.size() == 1 && gaps[0].first == gaps[0].last;
  std::string text = fmt::format("{} {}", one ? "frame" : "frames", fmt::join(texts, ", "));
  if (gaps.size() > most) text += fmt::format(" and {} gaps more", gaps.size() - most);
  return text;
}

}  // namespace

std::string frame_list(const std::vector<int>& numbers) {
  constexpr std::size_t most = 5;
  const std::vector<int> first(numbers.begin(),
                               numbers.begin() + static_cast<long>(std::min(most, numbers.size())));
  std::string text =
      fmt::format("{} {}", numbers.size() == 1 ? "frame" : "frames", fmt::join(first, ", "));
  if (numbers.size() > most) text += fmt::format(" and {} more", numbers.size() - most);
  return text;
}

FrameSet read_frames(const std::string& directory) {
  FrameSet set;
  set.directory = directory;
  const FrameFiles files = frame_files(directory);
  std::vector<int> bad;
  std::string first_reason;
  for (const int number : files.numbers) try {
      add(set, number);
    } catch (const InputError& error) {
      bad.push_back(number);
      if (first_reason.empty()) first_reason = error.what();
    }
  if (!bad.empty())
    set.notes.push_back(fmt::format("Left out, {}: {}.", frame_list(bad), first_reason));
  if (!files.gaps.empty()) set.notes.push_back(fmt::format("Missing: {}.", gap_list(files.gaps)));
  return set;
}

std::array<Vec<3>, 2> cloth_span(const FrameSet& frames, const std::vector<std::size_t>& shown) {
  std::array<Vec<3>, 2> span = {Vec<3>::Zero(), Vec<3>::Zero()};
  bool first = true;
  for (const std::size_t f : shown)
    for (std::size_t n = 0; n < frames.nodes; ++n) {
      Vec<3> x;
      for (int d = 0; d < 3; ++d)
        x[d] = frames.positions[f][static_cast<std::size_t>(d) * frames.nodes + n];
      span = first ? std::array<Vec<3>, 2>{x, x}
                   : std::array<Vec<3>, 2>{span[0].cwiseMin(x), span[1].cwiseMax(x)};
      first = false;
    }
  return span;
}

}  // namespace washtub
