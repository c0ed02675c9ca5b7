#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "case/solids.hpp"
#include "case/tables.hpp"

namespace washtub {
namespace {

constexpr int most_points = 128;  // of a side along an axis, where its two sides are compared
constexpr int most_parts = 256;   // of the box along an axis, where it is looked through
constexpr int turns = 64;         // angles at which a solid that turns is looked for

using Psi = std::function<double(const Vec<3>&)>;

/// What of a box has been found.
struct Seen {
  bool solid = false, water = false;
  bool both() const { return solid && water; }
};

/// Where a box is looked through: how small its parts become.
struct Fineness {
  Vec<3> part = Vec<3>::Zero();  ///< [m]
  bool cells = true;             ///< whether they are as small as the cells
};

/// Halves a box until psi, whose slope is at most 1, decides; what is undecided in the smallest
/// parts counts as touched by a solid, and as water too where cells are smaller still.
void look(const Psi& psi, const Vec<3>& middle, const Vec<3>& half, const Fineness& fineness,
          Seen& seen) {
  const double value = psi(middle), reach = half.norm();
  if (value > 0) seen.solid = true;
  if (value < 0) seen.water = true;
  if (seen.both() || std::abs(value) > reach) return;
  if (reach <= 0.5 * fineness.part.norm() * (1 + 1e-9)) {
    seen.solid = true;
    seen.water = seen.water || !fineness.cells;
    return;
  }
  const auto parts = [&](int axis) { return half[axis] > 0 ? 2 : 1; };
  for (int k = 0; k < parts(2); ++k)
    for (int j = 0; j < parts(1); ++j)
      for (int i = 0; i < parts(0); ++i)
        if (!seen.both())
          look(psi,
               middle + half.cwiseProduct(Vec<3>(i - 0.5, j - 0.5, parts(2) > 1 ? k - 0.5 : 0)),
               0.5 * half, fineness, seen);
}

/// "from ["0 m", "0 m"] to ["2 m", "1 m"]"
std::string box_text(const Case& whole) {
  const auto corner = [&](const Vec<3>& x) {
    std::string text;
    for (int axis = 0; axis < whole.dimension; ++axis)
      text += (axis > 0 ? ", " : "") + metres(x[axis]);
    return "[" + text + "]";
  };
  return fmt::format("from {} to {}", corner(whole.domain.lower),
                     corner(whole.domain.lower + whole.domain.size));
}

class SolidCheck {
 public:
  SolidCheck(const CaseFile& file, const Node& root)
      : file_(file), whole_(file.result), root_(root), solids_(build_solids(whole_)) {
    for (int axis = 0; axis < whole_.dimension; ++axis) {
      half_[axis] = 0.5 * whole_.domain.size[axis];
      middle_[axis] = whole_.domain.lower[axis] + half_[axis];
      const int cells = whole_.domain.cells[static_cast<std::size_t>(axis)];
      fineness_.part[axis] = whole_.domain.size[axis] / std::min(cells, most_parts);
      fineness_.cells = fineness_.cells && cells <= most_parts;
    }
  }

  void check() const {
    for (std::size_t body = 0; body < whole_.solids.size(); ++body) {
      check_reach(body);
      for (int axis = 0; axis < whole_.dimension; ++axis) check_fit(body, axis);
    }
    if (!whole_.solids.empty()) check_water();
  }

 private:
  Seen look_at(const Psi& psi) const {
    Seen seen;
    look(psi, middle_, half_, fineness_, seen);
    return seen;
  }

  /// psi of a solid and its images as they stand at an angle beyond that of t = 0.
  double psi(std::size_t body, const Vec<3>& x, double angle = 0) const {
    double largest = -1e300;
    for (const Solid& s : solids_)
      if (s.body == body)
        largest =
            std::max(largest, SolidPose(s.shape, s.centre, s.drive.angle(0) + angle, 0).psi(x));
    return largest;
  }

  /// A bound from above of psi of a solid at any angle.
  double swept_psi(std::size_t body, const Vec<3>& x) const {
    constexpr double step = 2 * std::numbers::pi / turns;
    double largest = -1e300, lever = 0;
    for (const Solid& s : solids_)
      if (s.body == body) lever = std::max(lever, (x - s.centre).head<2>().norm());
    for (int i = 0; i < turns; ++i) largest = std::max(largest, psi(body, x, i * step));
    return largest + 0.5 * step * lever;
  }

  /// The error at a key of a solid; at the box where the solid is one of the washer's.
  InputError error(std::size_t body, const char* key, const std::string& message) const {
    const auto& specs = file_.solids;
    const auto spec = std::find_if(specs.begin(), specs.end(), [&](const SolidSpec& s) {
      return s.name == whole_.solids[body].name;
    });
    const std::string text = fmt::format("solid \"{}\" {}", whole_.solids[body].name, message);
    if (spec == specs.end()) return error_at_key(root_, "domain.lower", "", text);
    const std::string table =
        specs.size() > 1 ? fmt::format("solid[{}].", spec - specs.begin() + 1) : "solid.";
    const bool given = find_key(root_, table + key) != nullptr;
    return error_at_key(root_, table + (given ? key : "shape"), "", text);
  }

  void check_reach(std::size_t body) const {
    const Seen seen = look_at([&](const Vec<3>& x) { return psi(body, x); });
    if (!seen.water)
      throw error(body, "shape",
                  fmt::format("fills the box, which leaves no water; the box reaches {}; try a "
                              "smaller shape, or its complement",
                              box_text(whole_)));
    if (seen.solid) return;
    if (whole_.solids[body].drive.moving() &&
        look_at([&](const Vec<3>& x) { return swept_psi(body, x); }).solid)
      return;
    throw error(body, "centre",
                fmt::format("lies wholly outside the box and acts on nothing, allowed: what "
                            "reaches into the box, {}; try another centre, or a larger domain.size",
                            box_text(whole_)));
  }

  /// The solids together.
  void check_water() const {
    const Seen seen = look_at([&](const Vec<3>& x) {
      double largest = -1e300;
      for (std::size_t body = 0; body < whole_.solids.size(); ++body)
        largest = std::max(largest, psi(body, x));
      return largest;
    });
    if (!seen.water)
      throw error_at_key(root_, "solid", "",
                         "the solids together fill the box, which leaves no "
                         "water; try smaller shapes");
  }

  /// A solid that goes on beyond periodic sides must be the same on both.
  void check_fit(std::size_t body, int axis) const {
    const SolidCase& solid = whole_.solids[body];
    const auto side = 2 * static_cast<std::size_t>(axis);
    if (whole_.domain.sides[side].kind != SideKind::periodic || has_images(solid, whole_, axis))
      return;
    const int last = solid.drive.moving() ? turns : 1;
    for (int turn = 0; turn < last; ++turn)
      if (!fits(body, axis, 2 * std::numbers::pi * turn / turns))
        throw error(body, "shape",
                    fmt::format("has no end along {0} and is not the same on both periodic {0} "
                                "sides, allowed: what ends, which acts with its images, or what "
                                "looks the same from both sides; try a shape that ends, or sides "
                                "that are not periodic",
                                "xyz"[axis]));
  }

  bool fits(std::size_t body, int axis, double angle) const {
    std::array<int, 3> points{1, 1, 1};
    for (int d = 0; d < whole_.dimension; ++d)
      if (d != axis)
        points[static_cast<std::size_t>(d)] =
            std::min(most_points, whole_.domain.cells[static_cast<std::size_t>(d)]);
    const double least = 1e-9 * half_.norm();
    for (int k = 0; k < points[2]; ++k)
      for (int j = 0; j < points[1]; ++j)
        for (int i = 0; i < points[0]; ++i) {
          Vec<3> x = middle_;
          const Vec<3> share((i + 0.5) / points[0], (j + 0.5) / points[1], (k + 0.5) / points[2]);
          x += 2 * half_.cwiseProduct(share - Vec<3>::Constant(0.5));
          x[axis] = middle_[axis] - half_[axis];
          const double a = psi(body, x, angle);
          x[axis] = middle_[axis] + half_[axis];
          const double b = psi(body, x, angle);
          if (a * b < 0 && std::min(std::abs(a), std::abs(b)) > least) return false;
        }
    return true;
  }

  const CaseFile& file_;
  const Case& whole_;
  const Node& root_;
  std::vector<Solid> solids_;
  Vec<3> middle_ = Vec<3>::Zero(), half_ = Vec<3>::Zero();
  Fineness fineness_;
};

}  // namespace

void check_solids(const CaseFile& file, const Node& root) { SolidCheck(file, root).check(); }

}  // namespace washtub
