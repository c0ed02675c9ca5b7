#include "io/frame_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>

#include "base/error.hpp"

namespace washtub {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view before = "frame_", after = ".h5";

std::string frame_name(int number) { return fmt::format("{}{:06d}{}", before, number, after); }

/// The number in "frame_000012.h5"; none for other names.
std::optional<int> frame_number(std::string_view name) {
  if (!name.starts_with(before)) return {};
  int number = 0;
  const auto digits = name.substr(before.size());
  const auto [end, error] = std::from_chars(digits.begin(), digits.end(), number);
  if (error != std::errc() || number < 0 || name != frame_name(number)) return {};
  return number;
}

/// For reading only, without locks: some file systems have none, and finished frames never change.
hid_t open(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access, false, true);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access);
  if (file < 0) throw InputError(fmt::format("{}: is no whole frame ({})", path, hdf5_error()));
  return file;
}

/// Datasets of the cloth that are no fields.
constexpr std::array<std::string_view, 4> mesh_parts = {"positions", "cells", "piece", "pieces"};

herr_t keep_link(hid_t, const char* name, const H5L_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

herr_t keep_name(hid_t, const char* name, const H5A_info_t*, void* names) {
  static_cast<std::vector<std::string>*>(names)->emplace_back(name);
  return 0;
}

/// Whether an attribute has one value; the library would write all it has into the room for one.
bool is_single(hid_t attribute) {
  const Hdf5Handle space(H5Aget_space(attribute), H5Sclose);
  return H5Sget_simple_extent_npoints(space) == 1;
}

/// Marks the directions in which some cell of a piece joins its last nodes to its first ones.
void mark_closed(std::vector<ClothFrame::Piece>& pieces, const std::vector<int>& cells,
                 const std::vector<int>& piece) {
  const std::size_t corners = piece.empty() ? 1 : cells.size() / piece.size();
  for (std::size_t c = 0; c < piece.size(); ++c) {
    auto& p = pieces[static_cast<std::size_t>(piece[c])];
    const int* nodes = &cells[c * corners];
    const int from = nodes[0] - p.first, to = nodes[corners == 4 ? 2 : 1] - p.first;
    const int nr = p.extent[0];
    if (corners == 4 && to % nr < from % nr) p.closed[0] = true;
    if (to / nr < from / nr) p.closed[1] = true;
  }
}

}  // namespace

FrameFiles frame_files(const std::string& directory) {
  FrameFiles found;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(directory) / "frames", error))
    if (const auto number = frame_number(entry.path().filename().string()))
      found.numbers.push_back(*number);
  std::sort(found.numbers.begin(), found.numbers.end());
  int before_it = -1;
  for (const int number : found.numbers) {
    if (number - before_it > 1) found.gaps.push_back({before_it + 1, number - 1});
    before_it = number;
  }
  return found;
}

std::string frame_path(const std::string& directory, int number) {
  return (fs::path(directory) / "frames" / frame_name(number)).string();
}

FrameReader::FrameReader(const std::string& path) : path_(path), file_(open(path), H5Fclose) {}

void FrameReader::fail(const std::string& what) const {
  throw InputError(fmt::format("{}: {}", path_, what));
}

double FrameReader::attribute(const std::string& name) const {
  const Hdf5Handle found(H5Aopen(file_, name.c_str(), H5P_DEFAULT), H5Aclose);
  double value = 0;
  if (found < 0 || !is_single(found) || !is_number({H5Aget_type(found), H5Tclose}) ||
      H5Aread(found, H5T_NATIVE_DOUBLE, &value) < 0)
    fail(fmt::format("has no \"{}\"; it may be of another version", name));
  return value;
}

std::vector<SolidAngle> FrameReader::solids() const {
  std::vector<std::string> names;
  hsize_t at = 0;
  H5Aiterate2(file_, H5_INDEX_NAME, H5_ITER_NATIVE, &at, keep_name, &names);
  const std::string_view head = "angle of ", tail = " [rad]";
  std::vector<SolidAngle> solids;
  for (const std::string& name : names)
    if (name.starts_with(head) && name.ends_with(tail))
      solids.push_back(
          {name.substr(head.size(), name.size() - head.size() - tail.size()), attribute(name)});
  return solids;
}

std::vector<hsize_t> FrameReader::extent(const std::string& name) const {
  const Hdf5Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (dataset < 0) fail(fmt::format("has no dataset {}; it may be of another version", name));
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  std::vector<hsize_t> n(static_cast<std::size_t>(std::max(0, H5Sget_simple_extent_ndims(space))));
  H5Sget_simple_extent_dims(space, n.data(), nullptr);
  return n;
}

template <class T>
std::vector<T> FrameReader::values(const std::string& name, hid_t type) const {
  const std::vector<hsize_t> n = extent(name);
  const double count = std::accumulate(n.begin(), n.end(), 1.0, std::multiplies<>());
  if (count > static_cast<double>(bytes()))
    fail(fmt::format("dataset {} is damaged: larger than its file", name));
  std::vector<T> out(static_cast<std::size_t>(count));
  const Hdf5Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (!is_number({H5Dget_type(dataset), H5Tclose}))
    fail(fmt::format("dataset {} does not hold numbers", name));
  if (!out.empty() && H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, out.data()) < 0)
    fail(fmt::format("dataset {} cannot be read ({})", name, hdf5_error()));
  return out;
}

std::uintmax_t FrameReader::bytes() const { return fs::file_size(path_); }

std::vector<double> FrameReader::per_node(const std::string& name, std::size_t count) const {
  auto out = values<double>(name, H5T_NATIVE_DOUBLE);
  if (out.size() != count)
    fail(fmt::format("dataset {} has {} values for {}", name, out.size(), count));
  return out;
}

ClothFrame FrameReader::cloth() const {
  ClothFrame cloth;
  if (H5Lexists(file_, "cloth", H5P_DEFAULT) <= 0) return cloth;
  const auto index = values<int>("cloth/pieces", H5T_NATIVE_INT);
  std::size_t nodes = 0;
  for (std::size_t i = 0; i + 2 < index.size(); i += 3) {
    const ClothFrame::Piece piece{index[i], {index[i + 1], index[i + 2]}, {}};
    if (piece.first != static_cast<int>(nodes) || piece.extent[0] < 1 || piece.extent[1] < 1)
      fail("dataset cloth/pieces is no list of pieces; it may be of another version");
    nodes += static_cast<std::size_t>(piece.extent[0]) * static_cast<std::size_t>(piece.extent[1]);
    if (nodes > bytes())
      fail("dataset cloth/pieces is damaged: more nodes than the file has bytes");
    cloth.pieces.push_back(piece);
  }
  cloth.positions = per_node("cloth/positions", 3 * nodes);
  for (const std::string& name : names("cloth")) {
    if (std::find(mesh_parts.begin(), mesh_parts.end(), name) != mesh_parts.end()) continue;
    if (extent("cloth/" + name).size() != 1) continue;  // of a later version
    cloth.fields.push_back({field("cloth", name, 1), per_node("cloth/" + name, nodes)});
  }
  const auto cells = values<int>("cloth/cells", H5T_NATIVE_INT);
  const auto piece = values<int>("cloth/piece", H5T_NATIVE_INT);
  for (const int p : piece)
    if (p < 0 || p >= static_cast<int>(cloth.pieces.size()))
      fail(fmt::format("dataset cloth/piece names piece {} of {}", p, cloth.pieces.size()));
  if (cells.size() != 4 * piece.size() && cells.size() != 2 * piece.size())
    fail("dataset cloth/cells does not fit cloth/piece");
  for (const int n : cells)
    if (n < 0 || n >= static_cast<int>(nodes))
      fail(fmt::format("dataset cloth/cells names node {} of {}", n, nodes));
  mark_closed(cloth.pieces, cells, piece);
  return cloth;
}

std::vector<std::string> FrameReader::names(const std::string& group) const {
  std::vector<std::string> names;
  const Hdf5Handle found(H5Gopen2(file_, group.c_str(), H5P_DEFAULT), H5Gclose);
  if (found < 0) fail(fmt::format("has no group {}; it may be of another version", group));
  hsize_t at = 0;
  H5Literate(found, H5_INDEX_NAME, H5_ITER_INC, &at, keep_link, &names);
  return names;
}

std::string FrameReader::text(hid_t dataset, const char* name) const {
  if (H5Aexists(dataset, name) <= 0) return "";
  const Hdf5Handle attribute(H5Aopen(dataset, name, H5P_DEFAULT), H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute), H5Tclose);
  if (H5Tget_class(type) != H5T_STRING || H5Tis_variable_str(type) > 0) return "";
  if (!is_single(attribute) || H5Tget_size(type) > bytes()) return "";
  std::string text(H5Tget_size(type), ' ');
  return H5Aread(attribute, type, text.data()) < 0 ? "" : text;
}

FieldDescription FrameReader::field(const std::string& group, const std::string& name,
                                    std::size_t components) const {
  const Hdf5Handle dataset(H5Dopen2(file_, (group + "/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  const std::string label = text(dataset, "label");
  return {name, label.empty() ? name : label, text(dataset, "unit"), static_cast<int>(components),
          text(dataset, "meaning")};
}

/// From any of its fields: they have the same cells.
std::array<int, 3> FrameReader::cells() const {
  for (const std::string& name : names("fluid")) {
    const std::vector<hsize_t> n = extent("fluid/" + name);
    if (n.size() != 3 && n.size() != 4) continue;
    const double count = std::accumulate(n.begin(), n.end(), 1.0, std::multiplies<>());
    const auto most = static_cast<hsize_t>(std::numeric_limits<int>::max());
    if (count < 1 || count > static_cast<double>(bytes()) ||
        *std::max_element(n.begin(), n.end()) > most)
      fail(fmt::format("dataset fluid/{} is damaged: {:.3g} cells", name, count));
    return {static_cast<int>(n[2]), static_cast<int>(n[1]), static_cast<int>(n[0])};
  }
  fail("has no field of the water; it may be of another version");
}

WaterFrame FrameReader::water(const std::vector<std::string>& wanted) const {
  WaterFrame water;
  water.cells = cells();
  const std::size_t count = static_cast<std::size_t>(water.cells[0]) *
                            static_cast<std::size_t>(water.cells[1]) *
                            static_cast<std::size_t>(water.cells[2]);
  for (const std::string& name : wanted.empty() ? names("fluid") : wanted) {
    const std::string path = "fluid/" + name;
    const std::vector<hsize_t> n = extent(path);
    const std::size_t components = n.size() == 4 ? n[3] : 1;
    auto read = values<float>(path, H5T_NATIVE_FLOAT);
    if (read.size() != components * count)
      fail(fmt::format("dataset {} has {} values for {}", path, read.size(), components * count));
    water.fields.push_back({field("fluid", name, components), std::move(read)});
  }
  return water;
}

}  // namespace washtub
