#include <algorithm>
#include <set>

#include "washer/case_tables.hpp"

namespace washtub {
namespace {

/// An error at a key of the file; where the file does not give the key, at the file, with the
/// value that was filled in.
InputError error_at_key(const Node& root, const std::string& key, const std::string& value,
                        const std::string& message) {
  if (const Node* node = find_key(root, key)) return error_at(*node, message);
  return InputError(fmt::format("{}: {} = {}: {}", root.where, key, value, message));
}

std::string metres(double length) { return fmt::format("\"{:.6g} m\"", length); }
std::string seconds(double time) { return fmt::format("\"{:.6g} s\"", time); }

void check_sides(const Case& whole, const Node& root) {
  const std::array<std::string, 3> axes = {"x", "y", "z"};
  for (size_t axis = 0; axis < static_cast<size_t>(whole.dimension); ++axis) {
    const SideCase& lower = whole.domain.sides[2 * axis];
    const SideCase& upper = whole.domain.sides[2 * axis + 1];
    const std::string key = "domain.sides." + axes[axis];
    if ((lower.kind == SideKind::periodic) != (upper.kind == SideKind::periodic))
      throw error_at_key(root, key + (lower.kind == SideKind::periodic ? "_lower" : "_upper"), "",
                         "periodic sides come in pairs, so the opposite side must be periodic too");
    if (lower.velocity[static_cast<int>(axis)] != 0)
      throw error_at_key(root, key + "_lower_velocity", "", "a wall can only move along itself");
    if (upper.velocity[static_cast<int>(axis)] != 0)
      throw error_at_key(root, key + "_upper_velocity", "", "a wall can only move along itself");
  }
}

void check_box(const CaseFile& file, const Node& root) {
  if (!file.washer) return;
  const DomainCase& domain = file.result.domain;
  const double radius = file.washer->radius;
  for (int axis = 0; axis < 2; ++axis)
    if (domain.lower[axis] > -radius || domain.lower[axis] + domain.size[axis] < radius)
      throw error_at_key(root, find_key(root, "domain.size") ? "domain.size" : "domain.lower", "",
                         fmt::format("the tub does not fit into the box, allowed: from {} to {} at "
                                     "least along x and y",
                                     metres(-radius), metres(radius)));
}

void check_names(const CaseFile& file, const Node& root) {
  std::set<std::string> seen;
  for (const SolidSpec& solid : file.solids)
    if (!seen.insert(solid.name).second)
      throw InputError(fmt::format("{}: solid.name = \"{}\": two solids have this name", root.where,
                                   solid.name));
}

void check_times(const Case& whole, const Node& root) {
  const TimeCase& time = whole.time;
  const OutputCase& output = whole.output;
  if (time.fixed && time.step == 0)
    throw error_at_key(root, "time.fixed", "true", "expected time.step along with it");
  if (output.window_begin >= output.window_end || output.window_end > time.end * (1 + 1e-9))
    throw error_at_key(root, "output.window", "",
                       fmt::format("allowed: a begin before the end, both from \"0 s\" to {} "
                                   "(time.end)",
                                   seconds(time.end)));
  if (output.every > time.end)
    throw error_at_key(root, "output.every", seconds(output.every),
                       fmt::format("allowed: up to {} (time.end)", seconds(time.end)));
}

/// The key of a member of the i-th of `total` cloth tables.
std::string cloth_key(size_t i, size_t total, const std::string& name) {
  return total > 1 ? fmt::format("cloth[{}].{}", i + 1, name) : "cloth." + name;
}

/// What a piece must be smaller than: the tub's half section for pages of a book, else the tub or
/// the box.
struct Room {
  std::array<double, 2> size;
  const char* what;
};

Room room_of(const CaseFile& file, const ClothCase& cloth) {
  const Vec<3>& box = file.result.domain.size;
  const double widest = box.maxCoeff();
  if (!file.washer) return {{widest, widest}, "the box"};
  const WasherSpec& washer = *file.washer;
  if (cloth.arrangement == Arrangement::book)
    return {{washer.radius, washer.depth}, "the tub, whose radius and depth bound a page"};
  return {{2 * washer.radius, 2 * washer.radius}, "the tub"};
}

void check_size(const CaseFile& file, const ClothCase& cloth, const Node& root,
                const std::string& key) {
  const Room room = room_of(file, cloth);
  for (size_t i = 0; i + 1 < static_cast<size_t>(file.result.dimension); ++i)
    if (cloth.size[i] >= room.size[i])
      throw error_at_key(root, key, metres(cloth.size[i]),
                         fmt::format("the cloth is larger than {}, allowed: below {}", room.what,
                                     metres(room.size[i])));
}

/// A page of the book lies between axis and tub wall, bottom and surface.
void check_page(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  if (cloth.arrangement != Arrangement::book || !file.washer || cloth.count == 0) return;
  const size_t total = file.result.cloth.size();
  const double room = file.washer->radius - cloth.size[0];
  if (cloth.inner_radius > room)
    throw error_at_key(
        root, cloth_key(i, total, "inner_radius"), metres(cloth.inner_radius),
        fmt::format("the cloth reaches beyond the tub's wall, allowed: up to {}", metres(room)));
  const double height = file.washer->depth - cloth.size[1];
  if (cloth.bottom > height)
    throw error_at_key(
        root, cloth_key(i, total, "bottom"), metres(cloth.bottom),
        fmt::format("the cloth reaches above the water, allowed: up to {}", metres(height)));
}

void check_arrangement(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  const size_t total = file.result.cloth.size();
  if (cloth.arrangement == Arrangement::book && file.result.dimension == 2)
    throw error_at_key(root, cloth_key(i, total, "arrangement"), "\"book\"",
                       "pages need three dimensions, allowed in 2-D: \"random\", \"sheet\"");
  if (cloth.arrangement == Arrangement::sheet && cloth.count > 1)
    throw error_at_key(root, cloth_key(i, total, "count"), std::to_string(cloth.count),
                       "a sheet is a single piece, allowed: 0 or 1");
}

void check_nodes(const CaseFile& file, const ClothCase& cloth, const Node& root,
                 const std::string& key) {
  const auto nodes = cloth_nodes(cloth, file.result);
  for (size_t i = 0; i + 1 < static_cast<size_t>(file.result.dimension); ++i)
    if (nodes[i] < 3)
      throw error_at_key(root, key, number_text(cloth.spacing),
                         fmt::format("leaves {} nodes along an edge of {}, at least 3 are needed; "
                                     "try more domain.cells or a smaller spacing",
                                     nodes[i], metres(cloth.size[i])));
}

}  // namespace

void check_case(const CaseFile& file, const Node& root) {
  check_sides(file.result, root);
  check_box(file, root);
  check_names(file, root);
  check_times(file.result, root);
  const auto& groups = file.result.cloth;
  for (size_t i = 0; i < groups.size(); ++i) {
    check_arrangement(file, groups[i], root, i);
    check_size(file, groups[i], root, cloth_key(i, groups.size(), "size"));
    check_page(file, groups[i], root, i);
    check_nodes(file, groups[i], root, cloth_key(i, groups.size(), "spacing"));
  }
}

}  // namespace washtub
