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
#include "solid/mapping.hpp"
#include "washer/rectangle.hpp"

namespace washtub {
namespace {

constexpr int most_draws = 10000;  // of one piece, before its group starts again
constexpr int most_starts = 20;    // of a group
constexpr double fineness = 1e-4;  // of the search for solids, in edge lengths

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

/// A rectangle about `centre`; `along` are unit vectors.
Rectangle centred(const Vec<3>& centre, const Vec<3>& along_r, const Vec<3>& along_s,
                  std::array<double, 2> size) {
  const Vec<3> r = size[0] * along_r, s = size[1] * along_s;
  return {centre - 0.5 * (r + s), {r, s}};
}

/// Piece p of a group that is still flat.
template <int D>
Rectangle flat_piece(const Cloth<D>& cloth, const ClothGroup<D>& group, int p) {
  const auto X = cloth.piece(group, p);
  const auto at = [&](int i, int j) { return in_space<D>(X[group.sheet.node(i, j)]); };
  const auto [nr, ns] = group.sheet.extent;
  return {at(0, 0), {at(nr - 1, 0) - at(0, 0), at(0, ns - 1) - at(0, 0)}};
}

/// Finds the places of the pieces of one group.
template <int D>
class Placer {
 public:
  Placer(const ClothCase& cloth, const Case& whole, const Cloth<D>& others)
      : cloth_(cloth), whole_(whole), draw_(cloth.seed) {
    for (const SolidCase& s : whole.solids)
      solids_.emplace_back(s.shape, s.centre, s.drive.angle(0), s.drive.speed(0));
    for (const ClothCase& group : whole.cloth) pieces_ += group.count;
    for (const auto& group : others.groups)
      for (int p = 0; p < group.pieces; ++p) placed_.push_back(flat_piece(others, group, p));
  }

  /// The pieces of the group.
  std::vector<Rectangle> place() {
    const auto first = placed_.end() - placed_.begin();
    for (int start = 0; start < most_starts; ++start) {
      placed_.resize(first);
      if (fill()) return {placed_.begin() + first, placed_.end()};
    }
    throw no_place();
  }

 private:
  std::array<double, 2> size() const { return {cloth_.size[0], D == 3 ? cloth_.size[1] : 0.0}; }

  Rectangle page() {
    const double angle = 2 * std::numbers::pi * static_cast<double>(placed_.size()) / pieces_;
    const Vec<3> outwards(std::cos(angle), std::sin(angle), 0), upwards = Vec<3>::UnitZ();
    Vec<3> centre = (cloth_.inner_radius + 0.5 * cloth_.size[0]) * outwards;
    centre[2] = whole_.domain.lower[2] + cloth_.bottom + 0.5 * cloth_.size[1];
    centre += cloth_.shift * draw_.normals();
    const Vec<3> by = cloth_.tilt * draw_.normals();
    const Vec<3> turn = by[0] * outwards + by[1] * upwards + by[2] * outwards.cross(upwards);
    const Eigen::AngleAxisd tilt(turn.norm(), turn.stableNormalized());
    return centred(centre, tilt * outwards, tilt * upwards, size());
  }

  Rectangle anywhere() {
    Vec<3> centre = Vec<3>::Zero();
    for (int d = 0; d < D; ++d)
      centre[d] = whole_.domain.lower[d] + draw_.uniform() * whole_.domain.size[d];
    Vec<3> r = draw_.normals(), s = draw_.normals();
    if constexpr (D == 2) r[2] = 0;
    r.normalize();
    s = (s - s.dot(r) * r).normalized();
    return centred(centre, r, s, size());
  }

  bool fill() {
    for (int p = 0; p < cloth_.count; ++p) {
      const auto piece = cloth_.arrangement == Arrangement::sheet ? sheet() : free_place();
      if (!piece) return false;
      placed_.push_back(*piece);
    }
    return true;
  }

  std::optional<Rectangle> free_place() {
    hits_.clear();
    for (int k = 0; k < most_draws; ++k) {
      const Rectangle piece = cloth_.arrangement == Arrangement::book ? page() : anywhere();
      const std::string what = obstacle(piece, cloth_.clearance, false);
      if (what.empty()) return piece;
      ++hits_[what];
    }
    return {};
  }

  InputError no_place() const {
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    return InputError(fmt::format(
        "piece {} of {}: no free place in {} draws, {} times over; most often it comes nearer than "
        "{:.3g} m to {}; try a smaller cloth.count, cloth.size or cloth.clearance, or another "
        "cloth.seed",
        placed_.size() + 1, pieces_, most_draws, most_starts, cloth_.clearance,
        std::max_element(hits_.begin(), hits_.end(), less)->first));
  }

  std::optional<Rectangle> sheet() const {
    const auto& [r, s] = cloth_.along;
    const bool skew = D == 3 && (std::abs(s.norm() - 1) > 1e-9 || std::abs(r.dot(s)) > 1e-9);
    if (std::abs(r.norm() - 1) > 1e-9 || skew)
      throw InputError(
          fmt::format("piece {}: its directions must be of unit length and at right angles",
                      placed_.size() + 1));
    const auto length = size();
    const Rectangle piece{cloth_.origin, {length[0] * r, length[1] * s}};
    const std::string what = obstacle(piece, 0, true);
    if (!what.empty())
      throw InputError(
          fmt::format("piece {}: the sheet touches {}; try another cloth.origin or a smaller "
                      "cloth.size",
                      placed_.size() + 1, what));
    return piece;
  }

  /// What is nearer than `clearance`; empty if nothing is.
  std::string obstacle(const Rectangle& piece, double clearance, bool may_wrap) const {
    for (const Rectangle& other : placed_)
      if (hits(other, piece, clearance)) return "other pieces";
    if (std::string side = side_hit(piece, clearance, may_wrap); !side.empty()) return side;
    const double resolution = fineness * piece.edge[0].norm();
    for (std::size_t i = 0; i < solids_.size(); ++i)
      if (!is_clear_of(solids_[i], piece, clearance, resolution))
        return fmt::format("solid \"{}\"", whole_.solids[i].name);
    return {};
  }

  static bool hits(const Rectangle& a, const Rectangle& b, double clearance) {
    if ((a.centre() - b.centre()).norm() > a.reach() + b.reach() + clearance) return false;
    const double d = distance(a, b);
    return d < clearance || d == 0;
  }

  std::string side_hit(const Rectangle& piece, double clearance, bool may_wrap) const {
    static constexpr const char* names[] = {"the lower x side", "the upper x side",
                                            "the lower y side", "the upper y side",
                                            "the floor",        "the water surface"};
    const DomainCase& box = whole_.domain;
    for (int d = 0; d < D; ++d)
      for (int side = 0; side < 2; ++side) {
        const int i = 2 * d + side;
        if (may_wrap && box.sides[i].kind == SideKind::periodic) continue;
        for (const Vec<3>& x : piece.corners()) {
          const double inwards =
              side == 0 ? x[d] - box.lower[d] : box.lower[d] + box.size[d] - x[d];
          if (inwards < clearance - 1e-12 * box.size[d]) return names[i];
        }
      }
    return {};
  }

  const ClothCase& cloth_;
  const Case& whole_;
  Draw draw_;
  std::vector<SolidPose> solids_;    ///< at t = 0
  std::vector<Rectangle> placed_;    ///< of all groups so far
  int pieces_ = 0;                   ///< of all groups
  std::map<std::string, int> hits_;  ///< what the last piece met, and how often
};

}  // namespace

template <int D>
std::vector<Vec<D>> place_cloth(const ClothCase& cloth, std::array<int, 2> nodes, const Case& whole,
                                const Cloth<D>& others) {
  const auto along = [](int i, int n) { return n > 1 ? static_cast<double>(i) / (n - 1) : 0; };
  Placer<D> placer(cloth, whole, others);
  std::vector<Vec<D>> where;
  for (const Rectangle& piece : placer.place())
    for (int j = 0; j < nodes[1]; ++j)
      for (int i = 0; i < nodes[0]; ++i)
        where.push_back(piece.at(along(i, nodes[0]), along(j, nodes[1])).template head<D>());
  return where;
}

template std::vector<Vec<2>> place_cloth(const ClothCase&, std::array<int, 2>, const Case&,
                                         const Cloth<2>&);
template std::vector<Vec<3>> place_cloth(const ClothCase&, std::array<int, 2>, const Case&,
                                         const Cloth<3>&);

}  // namespace washtub
