#include "washer/placement.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <random>

#include "base/error.hpp"
#include "case/solids.hpp"
#include "washer/packet.hpp"

namespace washtub {
namespace {

constexpr int most_draws = 10000;     // of one piece, before its group starts again
constexpr int most_starts = 20;       // of a group
constexpr double wall_cells = 0.6;    // from the wall to the first layer
constexpr int tries_per_place = 8;    // in a layer, at different heights
constexpr double least_layer = 1e-3;  // from one layer of pieces to the next, beyond clearance [m]
constexpr double fineness = 1e-4;     // of the search for solids, in edge lengths

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  /// Above 0, at most 1.
  double uniform() { return (static_cast<double>(engine_() >> 11) + 1) * 0x1p-53; }
  double normal() {
    const double size = std::sqrt(-2 * std::log(uniform()));
    return size * std::cos(2 * std::numbers::pi * uniform());
  }
  /// Three, one after the other.
  Vec<3> normals() {
    Vec<3> v;
    for (double& x : v) x = normal();
    return v;
  }

 private:
  std::mt19937_64 engine_;
};

/// "the upper x side"; what lies above or below by what it is.
std::string name_of_side(const DomainCase& box, int side) {
  const auto kind = [&](std::size_t i) { return box.sides[i].kind; };
  if (side == 4 && kind(4) == SideKind::no_slip) return "the floor";
  if (side == 5 && kind(5) == SideKind::slip && kind(4) != SideKind::slip)
    return "the water surface";
  return fmt::format("the {} {} side", side % 2 == 0 ? "lower" : "upper", "xyz"[side / 2]);
}

/// Finds the places of the pieces of one group.
class Placer {
 public:
  Placer(const ClothCase& cloth, const Case& whole, std::span<const Patch> others)
      : cloth_(cloth),
        whole_(whole),
        draw_(cloth.seed),
        solids_(build_solids(whole, whole.domain.size.maxCoeff())) {
    for (const Solid& solid : solids_) poses_.push_back(solid.at(0));
    for (const ClothCase& group : whole.cloth) pieces_ += group.count;
    for (const Patch& other : others) placed_.push_back({other, facets(other)});
  }

  /// The pieces of the group.
  std::vector<Patch> place() {
    const std::size_t first = placed_.size();
    for (int start = 0; start < most_starts; ++start) {
      placed_.resize(first);
      layer_depth_ = first_layer();
      layer_tries_ = 0;
      if (!fill()) continue;
      std::vector<Patch> own;
      for (std::size_t p = first; p < placed_.size(); ++p) own.push_back(placed_[p].patch);
      return own;
    }
    throw no_place();
  }

 private:
  struct Piece {
    Patch patch;
    Facets facets;
  };

  /// A piece of the group about a centre, bent along r.
  Patch piece(const Vec<3>& centre, const Vec<3>& along_r, const Vec<3>& along_s,
              double curvature) const {
    if (!is_packed(cloth_)) {
      const double s = whole_.dimension == 3 ? cloth_.size[1] : 0.0;
      return centred_patch(centre, along_r, along_s, {cloth_.size[0], s}, curvature);
    }
    Patch patch = centred_patch(centre, along_r, along_s, packet_.size, curvature);
    patch.thickness = packet_.thickness;
    return patch;
  }

  Patch page() {
    const double angle = 2 * std::numbers::pi * static_cast<double>(placed_.size()) / pieces_;
    const Vec<3> outwards(std::cos(angle), std::sin(angle), 0), upwards = Vec<3>::UnitZ();
    Vec<3> centre = (cloth_.inner_radius + 0.5 * start_extent(cloth_, 0)) * outwards;
    centre[2] = whole_.domain.lower[2] + cloth_.bottom + 0.5 * start_extent(cloth_, 1);
    centre += cloth_.shift * draw_.normals();
    const Vec<3> by = cloth_.tilt * draw_.normals();
    const Vec<3> turn = by[0] * outwards + by[1] * upwards + by[2] * outwards.cross(upwards);
    const Eigen::AngleAxisd tilt(turn.norm(), turn.stableNormalized());
    return piece(centre, tilt * outwards, tilt * upwards, 0);
  }

  Patch anywhere() {
    Vec<3> centre = Vec<3>::Zero();
    for (int d = 0; d < whole_.dimension; ++d)
      centre[d] = whole_.domain.lower[d] + draw_.uniform() * whole_.domain.size[d];
    Vec<3> r = draw_.normals(), s = draw_.normals();
    if (whole_.dimension == 2) r[2] = 0;
    r.normalize();
    s = (s - s.dot(r) * r).normalized();
    return piece(centre, r, s, cloth_.curvature);
  }

  /// Bent about the axis, in the next place of the layer at hand, which starts at a random angle.
  /// Each place is tried at a few heights.
  Patch in_layer() {
    const Patch flat = piece(Vec<3>::Zero(), Vec<3>::UnitX(), Vec<3>::UnitY(), 0);
    // As far from all sides as half of it is thick, and the flat pieces that stand for it are off.
    const double c = cloth_.clearance + 0.5 * flat.thickness + least_layer;
    const double depth = whole_.domain.size[2], radius = whole_.scale.length - layer_depth_ - c;
    const auto fit = [](double room, double size) {
      return std::max(1, static_cast<int>(room / size));
    };
    const int round = fit(2 * std::numbers::pi * radius, flat.size[0] + c);
    const int tiers = fit(depth - c, flat.size[1] + c);
    if (layer_tries_ == 0) layer_angle_ = 2 * std::numbers::pi * draw_.uniform();
    const int place = layer_tries_++ / tries_per_place;
    if (layer_tries_ == round * tiers * tries_per_place) next_layer(flat.thickness);
    const double angle = layer_angle_ + 2 * std::numbers::pi * (place % round) / round;
    const double tier = (depth - c) / tiers, play = std::max(0.0, tier - flat.size[1] - c);
    const Vec<3> outwards(std::cos(angle), std::sin(angle), 0), upwards = Vec<3>::UnitZ();
    Vec<3> centre = radius * outwards;
    centre[2] = whole_.domain.lower[2] + c + 0.5 * flat.size[1] + tier * (place / round) +
                play * draw_.uniform();
    return piece(centre, upwards.cross(outwards), upwards, -1 / radius);
  }

  /// Nodes that start in the cell at the wall have hardly any water about them.
  double first_layer() const { return wall_cells * whole_.domain.size[0] / whole_.domain.cells[0]; }

  /// Inwards from the last layer, or again from the wall once that is past the axis.
  void next_layer(double thickness) {
    layer_tries_ = 0;
    layer_depth_ += thickness + cloth_.clearance + least_layer;
    if (layer_depth_ + thickness > 0.9 * whole_.scale.length) layer_depth_ = first_layer();
  }

  /// Where the next piece might start.
  Patch candidate() {
    switch (cloth_.arrangement) {
      case Arrangement::book:
        return page();
      case Arrangement::random:
      case Arrangement::dropped:
        return anywhere();
      case Arrangement::layers:
        return in_layer();
      case Arrangement::sheet:
        return sheet_patch(cloth_, whole_);
      case Arrangement::ring:
        return ring_patch(cloth_);
    }
    throw InputError("cloth.arrangement: not one of those that are placed");
  }

  bool fill() {
    for (int p = 0; p < cloth_.count; ++p) {
      const auto piece = is_single() ? single() : free_place();
      if (!piece) return false;
      placed_.push_back(*piece);
    }
    return true;
  }

  bool is_single() const {
    return cloth_.arrangement == Arrangement::sheet || cloth_.arrangement == Arrangement::ring;
  }

  /// Whether a sheet or ring may start through others.
  bool is_parted_later() const {
    return is_single() && whole_.contact.untangle && whole_.contact.scheme != ContactScheme::none;
  }

  std::optional<Piece> free_place() {
    hits_.clear();
    if (is_packed(cloth_)) packet_ = make_packet(cloth_, whole_, placed_.size());
    for (int k = 0; k < most_draws; ++k) {
      Piece piece{candidate(), {}};
      piece.facets = facets(piece.patch);
      const std::string what = obstacle(piece.facets, piece.facets, cloth_.clearance);
      if (what.empty()) {
        piece.patch.packed = packet_.nodes;
        return piece;
      }
      ++hits_[what];
    }
    return {};
  }

  InputError no_place() const {
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    return InputError(fmt::format(
        "piece {} of {}: no free place in {} draws, {} times over; most often it comes nearer than "
        "{:.3g} m to {}; try a smaller cloth.count, cloth.size or cloth.clearance, pieces that are "
        "folded (cloth.folded), or another cloth.seed",
        placed_.size() + 1, pieces_, most_draws, most_starts, cloth_.clearance,
        std::max_element(hits_.begin(), hits_.end(), less)->first));
  }

  std::optional<Piece> single() {
    const bool ring = cloth_.arrangement == Arrangement::ring;
    const Patch patch = candidate();
    const Facets all = facets(patch);
    const std::string what = obstacle(all, ring ? all : free_part(patch), 0);
    if (!what.empty())
      throw InputError(fmt::format("piece {}: the {} touches {}; try another cloth.{}",
                                   placed_.size() + 1, ring ? "ring" : "sheet", what,
                                   ring ? "centre or a smaller cloth.radius"
                                        : "origin or a smaller cloth.size") +
                       (what == "other pieces" ? ", or contact.untangle = true" : ""));
    return Piece{patch, all};
  }

  /// What lies between the outermost nodes that may move.
  Facets free_part(const Patch& patch) const {
    std::array<std::array<double, 2>, 2> range{};
    for (int d = 0; d + 1 < whole_.dimension; ++d) {
      const auto lines = node_lines(patch, cloth_, whole_, d);
      const auto held = [&](int end) {
        return is_held(cloth_.clamped, d, end) ? 2U : is_held(cloth_.pinned, d, end) ? 1U : 0U;
      };
      range[d] = {lines[held(0)], lines[lines.size() - 1 - held(1)]};
    }
    return facets(patch, range[0], range[1]);
  }

  /// What is nearer than `clearance` to a piece, whose part `free` must stay out of solids at
  /// rest, and all of it out of moving ones; empty if nothing is.
  std::string obstacle(const Facets& piece, const Facets& free, double clearance) const {
    for (const Piece& other : placed_)
      if (!is_parted_later() && near(other.facets, piece, clearance)) return "other pieces";
    for (const Rectangle& flat : piece.flat)
      if (std::string side = side_hit(flat, clearance + piece.slack); !side.empty()) return side;
    for (std::size_t i = 0; i < solids_.size(); ++i)
      for (const Facets& part = solids_[i].drive.moving() ? piece : free;
           const Rectangle& flat : part.flat)
        if (!is_clear_of(poses_[i], flat, clearance + part.slack, fineness * flat.edge[0].norm()))
          return fmt::format("solid \"{}\"", solids_[i].name);
    return {};
  }

  std::string side_hit(const Rectangle& piece, double clearance) const {
    const DomainCase& box = whole_.domain;
    for (int d = 0; d < whole_.dimension; ++d)
      for (int side = 0; side < 2; ++side) {
        const int i = 2 * d + side;
        if (is_single() && box.sides[i].kind == SideKind::periodic) continue;
        for (const Vec<3>& x : piece.corners()) {
          const double inwards =
              side == 0 ? x[d] - box.lower[d] : box.lower[d] + box.size[d] - x[d];
          if (inwards < clearance - 1e-12 * box.size[d]) return name_of_side(box, i);
        }
      }
    return {};
  }

  const ClothCase& cloth_;
  const Case& whole_;
  Draw draw_;
  std::vector<Solid> solids_;        ///< with images that a sheet may reach
  std::vector<SolidPose> poses_;     ///< of them, at t = 0
  std::vector<Piece> placed_;        ///< of all groups so far
  int pieces_ = 0;                   ///< of all groups
  Packet packet_;                    ///< the piece that is to be placed, if it is packed
  double layer_depth_ = 0;           ///< of the layer of pieces at hand, from the wall [m]
  double layer_angle_ = 0;           ///< where it begins [rad]
  int layer_tries_ = 0;              ///< of its places so far
  std::map<std::string, int> hits_;  ///< what the last piece met, and how often
};

}  // namespace

std::vector<Patch> place_cloth(const ClothCase& cloth, const Case& whole,
                               std::span<const Patch> others) {
  return Placer(cloth, whole, others).place();
}

namespace {

/// The packet along the bent patch, each row as long as it is.
std::vector<Vec<3>> packed_places(const Patch& patch) {
  std::vector<Vec<3>> where;
  for (const Vec<3>& x : patch.packed) {
    const double r = 0.5 * patch.size[0] + x[0] / (1 - patch.curvature * x[2]);
    where.push_back(patch.at(r, 0.5 * patch.size[1] + x[1]) + x[2] * patch.normal_at(r));
  }
  return where;
}

}  // namespace

std::vector<Vec<3>> node_places(const Patch& patch, const ClothCase& cloth, const Case& whole) {
  if (!patch.packed.empty()) return packed_places(patch);
  const auto r = node_lines(patch, cloth, whole, 0), s = node_lines(patch, cloth, whole, 1);
  std::vector<Vec<3>> where;
  for (const double y : s)
    for (const double x : r) where.push_back(patch.at(x, y));
  return where;
}

}  // namespace washtub
