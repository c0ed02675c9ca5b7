#include "case/resolution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "case/solids.hpp"

namespace washtub {
namespace {

constexpr double thin = 2;      // cells that a part of a solid should be thick
constexpr double narrow = 4;    // cells of the delta functions, so of cloth in a gap
constexpr double share = 0.02;  // of a surface, below which an edge or a corner is not meant
constexpr int fewest_places = 48, most_places = 128;  // along an axis, to look for surfaces at
constexpr double stride = 1.0 / 16;                   // along a ray, in cells

/// The solids of a case as they stand when it starts, with their images.
class Start {
 public:
  explicit Start(const Case& whole) : solids_(build_solids(whole)) {
    for (const Solid& solid : solids_) poses_.push_back(solid.at(0));
  }
  /// Of one of the case's solids and its images.
  double psi(std::size_t body, const Vec<3>& x) const {
    double largest = -1e300;
    for (std::size_t s = 0; s < solids_.size(); ++s)
      if (solids_[s].body == body) largest = std::max(largest, poses_[s].psi(x));
    return largest;
  }

 private:
  std::vector<Solid> solids_;
  std::vector<SolidPose> poses_;
};

/// Length of a ray from x along n until `ends` holds; `most` where it does not.
template <class Ends>
double ray(const Vec<3>& x, const Vec<3>& n, double most, double step, Ends&& ends) {
  for (double s = step; s < most; s += step)
    if (ends(x + s * n)) return s;
  return most;
}

class Resolution {
 public:
  explicit Resolution(const Case& whole) : whole_(whole), start_(whole) {
    for (int axis = 0; axis < whole.dimension; ++axis)
      h_[axis] = whole.domain.size[axis] / whole.domain.cells[static_cast<std::size_t>(axis)];
  }

  std::vector<std::string> doubts() const {
    std::vector<std::string> found;
    for (std::size_t s = 0; s < whole_.solids.size(); ++s) look_at(s, found);
    return found;
  }

 private:
  double psi(std::size_t body, const Vec<3>& x) const { return start_.psi(body, x); }

  /// Unit vector into the solid; zero along axes not in use and where psi has no slope.
  Vec<3> inward(std::size_t body, const Vec<3>& x, double h) const {
    Vec<3> slope = Vec<3>::Zero();
    for (int axis = 0; axis < whole_.dimension; ++axis) {
      const Vec<3> step = 1e-3 * h * Vec<3>::Unit(axis);
      slope[axis] = psi(body, x + step) - psi(body, x - step);
    }
    return slope.norm() > 0 ? Vec<3>(slope.normalized()) : slope;
  }

  /// Calls visit(point of the surface inside the box, unit vector into the solid), about once per
  /// cell of surface, more often on coarse grids and less often on fine ones.
  template <class Visit>
  void for_surface(std::size_t body, Visit&& visit) const {
    std::array<int, 3> cells = whole_.domain.cells;
    Vec<3> spacing = Vec<3>::Zero();
    for (int axis = 0; axis < whole_.dimension; ++axis) {
      auto& n = cells[static_cast<std::size_t>(axis)];
      n = std::clamp(n, fewest_places, most_places);
      spacing[axis] = whole_.domain.size[axis] / n;
    }
    const double h = spacing.maxCoeff();
    for (int k = 0; k < (whole_.dimension == 3 ? cells[2] : 1); ++k)
      for (int j = 0; j < cells[1]; ++j)
        for (int i = 0; i < cells[0]; ++i) {
          const Vec<3> x =
              whole_.domain.lower + spacing.cwiseProduct(Vec<3>(i + 0.5, j + 0.5, k + 0.5));
          const double depth = psi(body, x);
          if (std::abs(depth) > h) continue;
          const Vec<3> n = inward(body, x, h);
          const Vec<3> surface = x - depth * n;
          if (n.norm() > 0 && std::abs(psi(body, surface)) < 0.5 * stride * h) visit(surface, n);
        }
  }

  bool in_other(std::size_t own, const Vec<3>& x) const {
    for (std::size_t s = 0; s < whole_.solids.size(); ++s)
      if (s != own && psi(s, x) > 0) return true;
    return false;
  }

  void look_at(std::size_t own, std::vector<std::string>& found) const {
    const SolidCase& solid = whole_.solids[own];
    std::vector<double> thickness, gap;
    std::size_t points = 0;
    for_surface(own, [&](const Vec<3>& x, const Vec<3>& n) {
      // A cell's length along the normal: of a vertical fin the lateral one.
      const double cell = n.cwiseProduct(h_).norm();
      const double step = stride * cell;
      if (in_other(own, x - step * n)) return;
      ++points;
      const double through =
          ray(x, n, thin * cell, step, [&](const Vec<3>& p) { return psi(own, p) <= 0; });
      const double across =
          ray(x, -n, narrow * cell, step, [&](const Vec<3>& p) { return in_other(own, p); });
      if (through < thin * cell) thickness.push_back(through / cell);
      if (across < narrow * cell) gap.push_back(across / cell);
    });
    say(found, points, thickness, thin, solid.name + " has parts", "thick");
    say(found, points, gap, narrow, solid.name + " leaves gaps to other solids", "wide");
  }

  void say(std::vector<std::string>& found, std::size_t points, std::vector<double>& lengths,
           double least, const std::string& what, const char* measured) const {
    if (static_cast<double>(lengths.size()) <= share * static_cast<double>(points)) return;
    const auto middle = lengths.begin() + static_cast<long>(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    found.push_back(
        fmt::format("{} about {:.1f} cells {}, at least {:g} are resolved; try {:.1f} "
                    "times as many domain.cells",
                    what, *middle, measured, least, std::ceil(10 * least / *middle) / 10));
  }

  const Case& whole_;
  Start start_;
  Vec<3> h_ = Vec<3>::Zero();
};

}  // namespace

std::vector<std::string> unresolved(const Case& whole) { return Resolution(whole).doubts(); }

}  // namespace washtub
