#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "solid/shape_node.hpp"

namespace washtub {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

void require_positive(const char* shape, const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(
        fmt::format("{}: {} = {} m: expected a positive, finite length", shape, name, value));
}

void require_finite(const char* shape, const char* name, const Vec<3>& x) {
  if (!x.allFinite())
    throw InputError(fmt::format("{}: {} = ({}, {}, {}): expected finite components", shape, name,
                                 x[0], x[1], x[2]));
}

void require_order(const char* shape, const char* names, double lower, double upper) {
  if (!(lower < upper))
    throw InputError(fmt::format("{}: {} = {} m, {} m: expected the first below the second", shape,
                                 names, lower, upper));
}

struct Sphere final : Shape::Node {
  Sphere(const Vec<3>& c, double r) : centre(c), radius(r) {}
  double psi(const Vec<3>& x) const override { return radius - (x - centre).norm(); }
  Bounds bounds() const override {
    return {centre - Vec<3>::Constant(radius), centre + Vec<3>::Constant(radius)};
  }
  Vec<3> centre;
  double radius;
};

struct Cylinder final : Shape::Node {
  Cylinder(double r, double lower, double upper) : radius(r), z_lower(lower), z_upper(upper) {}
  double psi(const Vec<3>& x) const override {
    const double radial = std::sqrt(x[0] * x[0] + x[1] * x[1]) - radius;
    const double axial = std::max(z_lower - x[2], x[2] - z_upper);
    if (radial <= 0 || axial <= 0) return -std::max(radial, axial);
    return -std::sqrt(radial * radial + axial * axial);
  }
  Bounds bounds() const override {
    return {{-radius, -radius, z_lower}, {radius, radius, z_upper}};
  }
  double radius, z_lower, z_upper;
};

struct Box final : Shape::Node {
  Box(const Vec<3>& l, const Vec<3>& u) : lower(l), upper(u) {}
  double psi(const Vec<3>& x) const override {
    const Vec<3> beyond = (lower - x).cwiseMax(x - upper);
    const double largest = beyond.maxCoeff();
    return largest <= 0 ? -largest : -beyond.cwiseMax(0.0).norm();
  }
  Bounds bounds() const override { return {lower, upper}; }
  Vec<3> lower, upper;
};

struct Capsule final : Shape::Node {
  Capsule(const Vec<3>& from, const Vec<3>& to, double r)
      : a(from), along(to - from), radius(r), inverse(1 / std::max(along.squaredNorm(), 1e-300)) {}
  double psi(const Vec<3>& x) const override {
    const Vec<3> from = x - a;
    const double s = std::clamp(from.dot(along) * inverse, 0.0, 1.0);
    return radius - (from - s * along).norm();
  }
  Bounds bounds() const override {
    const Vec<3> b = a + along, r = Vec<3>::Constant(radius);
    return {a.cwiseMin(b) - r, a.cwiseMax(b) + r};
  }
  Vec<3> a, along;
  double radius, inverse;
};

struct HalfSpace final : Shape::Node {
  HalfSpace(const Vec<3>& p, const Vec<3>& n) : point(p), normal(n) {}
  double psi(const Vec<3>& x) const override { return normal.dot(point - x); }
  Bounds bounds() const override {
    return {Vec<3>::Constant(-infinity), Vec<3>::Constant(infinity)};
  }
  Vec<3> point, normal;
};

}  // namespace

Shape sphere(const Vec<3>& centre, double radius) {
  require_finite("sphere", "centre", centre);
  require_positive("sphere", "radius", radius);
  return Shape(std::make_shared<Sphere>(centre, radius));
}

Shape cylinder(double radius, double z_lower, double z_upper) {
  require_positive("cylinder", "radius", radius);
  require_order("cylinder", "z_lower, z_upper", z_lower, z_upper);
  return Shape(std::make_shared<Cylinder>(radius, z_lower, z_upper));
}

Shape box(const Vec<3>& lower, const Vec<3>& upper) {
  for (int k = 0; k < 3; ++k) require_order("box", "lower, upper", lower[k], upper[k]);
  return Shape(std::make_shared<Box>(lower, upper));
}

Shape capsule(const Vec<3>& a, const Vec<3>& b, double radius) {
  require_finite("capsule", "a", a);
  require_finite("capsule", "b", b);
  require_positive("capsule", "radius", radius);
  return Shape(std::make_shared<Capsule>(a, b, radius));
}

Shape half_space(const Vec<3>& point, const Vec<3>& normal) {
  require_finite("half_space", "point", point);
  require_finite("half_space", "normal", normal);
  if (normal.norm() == 0) throw InputError("half_space: normal = 0: expected a direction");
  return Shape(std::make_shared<HalfSpace>(point, normal.normalized()));
}

}  // namespace washtub
