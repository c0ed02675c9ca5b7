#include "washer/patch.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace washtub {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double turn = 0.1;  // of the direction from one facet to the next [rad], at most

/// Left of the first direction in 2-D, right-handed with both in 3-D.
Vec<3> normal_of(const std::array<Vec<3>, 2>& along) {
  if (along[1].squaredNorm() == 0) return {-along[0][1], along[0][0], 0};
  return along[0].cross(along[1]);
}

/// Bound of the curvature along r.
double sharpest(const Patch& patch) {
  const double wave = 2 * pi * patch.ripples / patch.size[0];
  return std::abs(patch.curvature) + std::abs(patch.ripple) * wave * wave;
}

}  // namespace

Vec<3> Patch::normal_at(double r) const {
  return std::cos(curvature * r) * normal - std::sin(curvature * r) * along[0];
}

Vec<3> Patch::at(double r, double s) const {
  const double angle = curvature * r;
  const double half = 0.5 * angle;
  const double chord = half == 0 ? r : r * std::sin(half) / half;
  Vec<3> x = origin + s * along[1] + chord * (std::cos(half) * along[0] + std::sin(half) * normal);
  if (ripple != 0) x += ripple * std::sin(2 * pi * ripples * r / size[0] + phase) * normal_at(r);
  return x;
}

Facets facets(const Patch& patch, std::array<double, 2> r, std::array<double, 2> s) {
  const double length = r[1] - r[0], bend = sharpest(patch);
  const int n = std::clamp(static_cast<int>(std::ceil(bend * length / turn)), 1, 4096);
  // A flat packet is a pile of sheets, whose slack reaches less far aside than that of one.
  const int sheets = patch.thickness > 0 && bend == 0 ? 4 : 1;
  Facets all;
  Vec<3> least = Vec<3>::Constant(1e300), most = -least;
  for (int i = 0; i < n; ++i) {
    const Vec<3> a = patch.at(r[0] + length * i / n, s[0]);
    const Vec<3> b = patch.at(r[0] + length * (i + 1) / n, s[0]);
    for (int k = 0; k < sheets; ++k) {
      const double up = patch.thickness * ((k + 0.5) / sheets - 0.5);
      all.flat.push_back({a + up * patch.normal, {b - a, (s[1] - s[0]) * patch.along[1]}});
      for (const Vec<3>& x : all.flat.back().corners()) {
        least = least.cwiseMin(x);
        most = most.cwiseMax(x);
      }
    }
  }
  all.slack = bend * length * length / (8.0 * n * n) + 0.5 * patch.thickness / sheets;
  all.centre = 0.5 * (least + most);
  all.reach = 0.5 * (most - least).norm();
  return all;
}

Facets facets(const Patch& patch) { return facets(patch, {0, patch.size[0]}, {0, patch.size[1]}); }

bool near(const Facets& a, const Facets& b, double clearance) {
  clearance += a.slack + b.slack;
  if ((a.centre - b.centre).norm() > a.reach + b.reach + clearance) return false;
  for (const Rectangle& p : a.flat)
    for (const Rectangle& q : b.flat) {
      if ((p.centre() - q.centre()).norm() > p.reach() + q.reach() + clearance) continue;
      const double d = distance(p, q);
      if (d < clearance || d == 0) return true;
    }
  return false;
}

Patch centred_patch(const Vec<3>& centre, const Vec<3>& along_r, const Vec<3>& along_s,
                    std::array<double, 2> size, double curvature) {
  Patch patch;
  const double angle = -0.5 * curvature * size[0];
  patch.along = {along_r, size[1] > 0 ? along_s : Vec<3>(Vec<3>::Zero())};
  patch.normal = normal_of(patch.along);
  patch.size = size;
  if (curvature != 0) {
    const Vec<3> forward = std::cos(angle) * along_r + std::sin(angle) * patch.normal;
    patch.normal = std::cos(angle) * patch.normal - std::sin(angle) * along_r;
    patch.along[0] = forward;
    patch.curvature = curvature;
  }
  patch.origin = centre - (patch.at(0.5 * size[0], 0.5 * size[1]) - patch.origin);
  return patch;
}

Patch sheet_patch(const ClothCase& cloth, const Case& whole) {
  Patch patch;
  patch.origin = cloth.origin;
  patch.along[0] = cloth.along[0];
  patch.along[1] = whole.dimension == 3 ? cloth.along[1] : Vec<3>(Vec<3>::Zero());
  patch.normal = normal_of(patch.along);
  for (int d = 0; d + 1 < whole.dimension; ++d)
    patch.size[d] =
        cloth.closed[d] ? cloth.along[d].cwiseAbs().dot(whole.domain.size) : cloth.size[d];
  patch.curvature = cloth.curvature;
  patch.ripple = cloth.ripple;
  patch.ripples = cloth.ripples;
  return patch;
}

/// An arc that goes all round: its normal points to the centre.
Patch ring_patch(const ClothCase& cloth) {
  Patch patch;
  patch.origin = cloth.centre + cloth.radius * Vec<3>::UnitX();
  patch.along = {Vec<3>::UnitY(), Vec<3>::Zero()};
  patch.normal = -Vec<3>::UnitX();
  patch.size = {2 * pi * cloth.radius, 0};
  patch.curvature = 1 / cloth.radius;
  patch.ripple = cloth.ripple;
  patch.ripples = cloth.ripples;
  patch.phase = -0.5 * pi;
  return patch;
}

/// Equal chords: nodes ds apart on an arc of curvature k turn by 2 asin(k ds/2) from one to the
/// next.
std::vector<double> node_lines(const Patch& patch, const ClothCase& cloth, const Case& whole,
                               int direction) {
  const int nodes = cloth_nodes(cloth, whole)[static_cast<std::size_t>(direction)];
  if (patch.size[direction] == 0) return {0};
  double step = patch.size[direction] / intervals(cloth, direction, nodes);
  const double half = 0.5 * patch.curvature * step;
  if (direction == 0 && half != 0 && cloth.arrangement != Arrangement::ring)
    step *= std::asin(half) / half;
  const double first = is_held(cloth.clamped, direction, 0) ? -0.5 : 0;
  std::vector<double> lines;
  for (int i = 0; i < nodes; ++i) lines.push_back((first + i) * step);
  return lines;
}

}  // namespace washtub
