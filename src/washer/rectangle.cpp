#include "washer/rectangle.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace washtub {
namespace {

double ratio(double part, double whole) { return whole > 0 ? part / whole : 0; }

/// Distance from the border of `a` and its corners to the inside of `b`; infinite if they do not
/// face it.
double distance_to_face(const Rectangle& a, const Rectangle& b) {
  constexpr double nowhere = std::numeric_limits<double>::infinity();
  const Vec<3> normal = b.edge[0].cross(b.edge[1]);
  if (normal.norm() == 0) return nowhere;
  const auto height = [&](const Vec<3>& x) { return (x - b.corner).dot(normal) / normal.norm(); };
  const auto faces = [&](const Vec<3>& x) {
    const double r = (x - b.corner).dot(b.edge[0]) / b.edge[0].squaredNorm();
    const double s = (x - b.corner).dot(b.edge[1]) / b.edge[1].squaredNorm();
    return r >= 0 && r <= 1 && s >= 0 && s <= 1;
  };
  double least = nowhere;
  const auto corners = a.corners();
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec<3>&p = corners[i], &q = corners[(i + 1) % 4];
    const double hp = height(p), hq = height(q);
    if (faces(p)) least = std::min(least, std::abs(hp));
    if (hp * hq < 0 && faces(p + hp / (hp - hq) * (q - p))) return 0;
  }
  return least;
}

}  // namespace

/// The nearest points of the lines, moved back into the segments one after the other.
double distance(const Segment& a, const Segment& b) {
  const Vec<3> u = a[1] - a[0], v = b[1] - b[0], w = a[0] - b[0];
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v);
  const double uw = u.dot(w), vw = v.dot(w);
  double s = std::clamp(ratio(uv * vw - vv * uw, uu * vv - uv * uv), 0.0, 1.0);
  const double t = std::clamp(ratio(uv * s + vw, vv), 0.0, 1.0);
  s = std::clamp(ratio(uv * t - uw, uu), 0.0, 1.0);
  return (w + s * u - t * v).norm();
}

double distance(const Rectangle& a, const Rectangle& b) {
  double least = std::min(distance_to_face(a, b), distance_to_face(b, a));
  const auto p = a.corners(), q = b.corners();
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      least =
          std::min(least, distance(Segment{p[i], p[(i + 1) % 4]}, Segment{q[j], q[(j + 1) % 4]}));
  return least;
}

bool is_clear_of(const SolidPose& solid, const Rectangle& piece, double clearance,
                 double resolution) {
  const double psi = solid.psi(piece.centre());
  if (psi > -clearance) return false;
  if (psi + piece.reach() <= -clearance || piece.reach() < resolution) return true;
  Rectangle half = piece;
  const std::size_t longer = piece.edge[0].squaredNorm() >= piece.edge[1].squaredNorm() ? 0 : 1;
  half.edge[longer] *= 0.5;
  if (!is_clear_of(solid, half, clearance, resolution)) return false;
  half.corner += half.edge[longer];
  return is_clear_of(solid, half, clearance, resolution);
}

}  // namespace washtub
