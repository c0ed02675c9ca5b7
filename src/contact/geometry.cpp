#include "contact/geometry.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace washtub {
namespace {

/// Of the nearest point of ab: its part of the way from a to b. 0 where a is b.
template <int D>
double along(const Vec<D>& x, const Vec<D>& a, const Vec<D>& b) {
  const Vec<D> ab = b - a;
  const double length = ab.squaredNorm();
  return length > 0 ? std::clamp((x - a).dot(ab) / length, 0.0, 1.0) : 0;
}

}  // namespace

std::array<double, 2> nearest_weights(const Vec<2>& x, const std::array<Vec<2>, 2>& segment) {
  const double t = along<2>(x, segment[0], segment[1]);
  return {1 - t, t};
}

/// The foot of the perpendicular where that is inside; else the nearest point of the three sides.
std::array<double, 3> nearest_weights(const Vec<3>& x, const std::array<Vec<3>, 3>& triangle) {
  const auto& [a, b, c] = triangle;
  const Vec<3> u = b - a, v = c - a, p = x - a;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), up = u.dot(p), vp = v.dot(p);
  const double whole = uu * vv - uv * uv;
  const double wb = vv * up - uv * vp, wc = uu * vp - uv * up;
  if (whole > 1e-14 * uu * vv && wb >= 0 && wc >= 0 && wb + wc <= whole)
    return {1 - (wb + wc) / whole, wb / whole, wc / whole};
  std::array<double, 3> best{};
  double least = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double t = along<3>(x, triangle[k], triangle[next]);
    const double d = (x - (1 - t) * triangle[k] - t * triangle[next]).squaredNorm();
    if (least >= 0 && d >= least) continue;
    least = d;
    best = {};
    best[k] = 1 - t;
    best[next] = t;
  }
  return best;
}

std::array<double, 2> nearest_parameters(const Vec<3>& a, const Vec<3>& b, const Vec<3>& c,
                                         const Vec<3>& d) {
  const Vec<3> u = b - a, v = d - c, r = a - c;
  const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), ur = u.dot(r), vr = v.dot(r);
  const double whole = uu * vv - uv * uv;
  double s = 0.5;
  if (whole > 1e-14 * uu * vv) s = std::clamp((uv * vr - ur * vv) / whole, 0.0, 1.0);
  const double t = along<3>(a + s * u, c, d);
  return {along<3>(c + t * v, a, b), t};
}

}  // namespace washtub
