#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/tables.hpp"

namespace washtub {
namespace {

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
  if (cloth.arrangement == Arrangement::layers)
    return {{2 * std::numbers::pi * washer.radius, washer.depth},
            "the tub, whose circumference and depth bound a piece bent about the axis"};
  return {{2 * washer.radius, 2 * washer.radius}, "the tub"};
}

void check_size(const CaseFile& file, const ClothCase& cloth, const Node& root,
                const std::string& key) {
  if (cloth.arrangement == Arrangement::ring) return;
  const bool single = cloth.arrangement == Arrangement::sheet;
  const Room room = room_of(file, cloth);
  for (size_t i = 0; i + 1 < static_cast<size_t>(file.result.dimension); ++i)
    if (!cloth.closed[i] && start_extent(cloth, static_cast<int>(i)) >= room.size[i])
      throw error_at_key(root, key, metres(cloth.size[i]),
                         fmt::format("the cloth is larger than {}, allowed: below {}{}", room.what,
                                     metres(room.size[i]),
                                     single ? "" : "; or folded (cloth.folded) as small as that"));
}

/// Where a page begins, and how much room there is for it.
struct PageEdge {
  const char* key;
  double begin, size, room;  ///< [m]
  const char* fault;
};

/// Blames the page's begin where the file gives it, else its size.
void check_edge(const PageEdge& edge, const Node& root, size_t i, size_t total) {
  if (edge.begin + edge.size <= edge.room) return;
  const std::string key = cloth_key(i, total, edge.key);
  if (find_key(root, key))
    throw error_at_key(
        root, key, "",
        fmt::format("{}, allowed: up to {}", edge.fault, metres(edge.room - edge.size)));
  throw error_at_key(root, cloth_key(i, total, "size"), "",
                     fmt::format("{} from its {} at {} (default) on, allowed: up to {} that way; "
                                 "try a smaller cloth.{}",
                                 edge.fault, edge.key, metres(edge.begin),
                                 metres(edge.room - edge.begin), edge.key));
}

/// A page of the book lies between axis and tub wall, bottom and surface.
void check_page(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  if (cloth.arrangement != Arrangement::book || !file.washer || cloth.count == 0) return;
  const size_t total = file.result.cloth.size();
  check_edge({"inner_radius", cloth.inner_radius, start_extent(cloth, 0), file.washer->radius,
              "the cloth reaches beyond the tub's wall"},
             root, i, total);
  check_edge({"bottom", cloth.bottom, start_extent(cloth, 1), file.washer->depth,
              "the cloth reaches above the water"},
             root, i, total);
}

void check_arrangement(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  const size_t total = file.result.cloth.size();
  if (cloth.arrangement == Arrangement::book && file.result.dimension == 2)
    throw error_at_key(
        root, cloth_key(i, total, "arrangement"), "\"book\"",
        "pages need three dimensions, allowed in 2-D: \"random\", \"dropped\", \"sheet\", "
        "\"ring\"");
  if (cloth.arrangement == Arrangement::layers && file.result.dimension == 2)
    throw error_at_key(
        root, cloth_key(i, total, "arrangement"), "\"layers\"",
        "layers need three dimensions, allowed in 2-D: \"random\", \"dropped\", \"sheet\", "
        "\"ring\"");
  if (cloth.crumpled > 0 && cloth.folded != std::array{1, 1})
    throw error_at_key(root, cloth_key(i, total, "crumpled"), "",
                       "a piece starts folded or crumpled, not both");
  if (cloth.arrangement == Arrangement::ring && file.result.dimension == 3)
    throw error_at_key(root, cloth_key(i, total, "arrangement"), "\"ring\"",
                       "a ring is a thread in the plane, allowed in 3-D: \"book\", \"random\", "
                       "\"layers\", \"sheet\"");
  const bool single =
      cloth.arrangement == Arrangement::sheet || cloth.arrangement == Arrangement::ring;
  if (single && cloth.count > 1)
    throw error_at_key(root, cloth_key(i, total, "count"), std::to_string(cloth.count),
                       fmt::format("a {} is a single piece, allowed: 0 or 1",
                                   cloth.arrangement == Arrangement::ring ? "ring" : "sheet"));
}

void check_nodes(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  static constexpr const char* edges[] = {"r", "s"};
  const auto nodes = cloth_nodes(cloth, file.result);
  const size_t total = file.result.cloth.size();
  for (int d = 0; d + 1 < file.result.dimension; ++d) {
    const int clamps = is_held(cloth.clamped, d, 0) + is_held(cloth.clamped, d, 1);
    const auto end = static_cast<size_t>(d);
    if (nodes[end] > most_nodes)
      throw error_at_key(root, cloth_key(i, total, "size"), "",
                         fmt::format("takes more than {} nodes along {} at {} lateral cells from "
                                     "one to the next (cloth.spacing); try a smaller cloth.size, a "
                                     "larger cloth.spacing or cloth.nodes",
                                     most_nodes, edges[d], cloth.spacing));
    if (nodes[end] >= 3 + clamps) continue;
    const bool given = cloth.nodes[0] > 0;
    throw error_at_key(root, cloth_key(i, total, given ? "nodes" : "spacing"),
                       number_text(cloth.spacing),
                       fmt::format("leaves {} nodes along {}, at least {} are needed; try {}",
                                   nodes[end], edges[d], 3 + clamps,
                                   given ? "more" : "more domain.cells or a smaller spacing"));
  }
}

/// A piece must not bend back onto itself at the start.
void check_bend(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  const double most = 0.95 * 2 * std::numbers::pi / cloth.size[0];
  const size_t total = file.result.cloth.size();
  if (std::abs(cloth.curvature) > most)
    throw error_at_key(root, cloth_key(i, total, "curvature"), number_text(cloth.curvature),
                       fmt::format("the piece would meet itself, allowed: up to \"{:.6g} m^-1\" "
                                   "either way for its length of {}",
                                   most, metres(cloth.size[0])));
  const bool goes_round = cloth.arrangement == Arrangement::ring || cloth.closed[0];
  if (goes_round && cloth.ripple != 0 && cloth.ripples != std::round(cloth.ripples))
    throw error_at_key(root, cloth_key(i, total, "ripples"), number_text(cloth.ripples),
                       "expected a whole number, since the cloth is closed");
}

/// The axis of the box that a direction of a sheet lies along; -1 if none.
int axis_of(const Vec<3>& direction) {
  for (int d = 0; d < 3; ++d)
    if (std::abs(std::abs(direction[d]) - 1) < 1e-9) return d;
  return -1;
}

/// A closed direction goes once through a periodic box; it has no edges that could be held.
void check_closed(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  const std::string key = cloth_key(i, file.result.cloth.size(), "closed");
  for (size_t d = 0; d < 2; ++d) {
    if (!cloth.closed[d]) continue;
    const int axis = axis_of(cloth.along[d]);
    if (axis < 0 || axis >= file.result.dimension ||
        file.result.domain.sides[2 * static_cast<size_t>(axis)].kind != SideKind::periodic)
      throw error_at_key(root, key, "true",
                         fmt::format("closed cloth goes through a periodic box: expected {} along "
                                     "an axis whose sides are \"periodic\"",
                                     d == 0 ? "along_r" : "along_s"));
    if (d == 0 && cloth.curvature != 0)
      throw error_at_key(root, key, "true",
                         "not along with a curvature; ripple bends closed cloth");
    for (const auto* held : {&cloth.pinned, &cloth.clamped})
      if (is_held(*held, static_cast<int>(d), 0) || is_held(*held, static_cast<int>(d), 1))
        throw error_at_key(root, key, "true",
                           fmt::format("has no edges {0}_lower and {0}_upper that could be held",
                                       d == 0 ? "r" : "s"));
  }
}

void check_held(const CaseFile& file, const ClothCase& cloth, const Node& root, size_t i) {
  const size_t total = file.result.cloth.size();
  const std::pair<const char*, const std::vector<Edge>*> lists[] = {{"pinned", &cloth.pinned},
                                                                    {"clamped", &cloth.clamped}};
  for (const auto& [name, list] : lists)
    for (const Edge edge : *list)
      if (file.result.dimension == 2 && (edge == Edge::s_lower || edge == Edge::s_upper))
        throw error_at_key(root, cloth_key(i, total, name), "",
                           "a thread has two ends, allowed in 2-D: \"r_lower\", \"r_upper\"");
  for (const Edge edge : cloth.pinned)
    if (std::count(cloth.clamped.begin(), cloth.clamped.end(), edge) > 0)
      throw error_at_key(root, cloth_key(i, total, "clamped"), "",
                         "an edge is either pinned or clamped, which also holds its direction");
}

}  // namespace

void check_cloth(const CaseFile& file, const Node& root) {
  const auto& groups = file.result.cloth;
  for (size_t i = 0; i < groups.size(); ++i) {
    check_arrangement(file, groups[i], root, i);
    check_size(file, groups[i], root, cloth_key(i, groups.size(), "size"));
    check_page(file, groups[i], root, i);
    check_held(file, groups[i], root, i);
    check_closed(file, groups[i], root, i);
    check_nodes(file, groups[i], root, i);
    check_bend(file, groups[i], root, i);
  }
}

}  // namespace washtub
