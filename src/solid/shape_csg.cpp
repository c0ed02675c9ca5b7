#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "solid/shape_node.hpp"

namespace washtub {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
const Bounds everywhere = {Vec<3>::Constant(-infinity), Vec<3>::Constant(infinity)};

/// Square of the distance from x to the box, 0 inside it.
double squared_distance(const Bounds& box, const Vec<3>& x) {
  return (box.lower - x).cwiseMax(x - box.upper).cwiseMax(0.0).squaredNorm();
}

/// A member is not evaluated where its box alone shows that it cannot be the nearest: outside the
/// box an exact member has psi <= -(distance to the box).
struct Union final : Shape::Node {
  struct Member {
    Shape shape;
    Bounds box;
  };
  explicit Union(const std::vector<Shape>& shapes) {
    for (const Shape& s : shapes) {
      exact = exact && s.exact_outside();
      members.push_back({s, s.exact_outside() ? s.bounds() : everywhere});
    }
  }
  double psi(const Vec<3>& x) const override {
    double best = -infinity;
    for (const Member& m : members) {
      const double away = squared_distance(m.box, x);
      if (away > 0 && (best >= 0 || away >= best * best)) continue;
      best = std::max(best, m.shape.psi(x));
    }
    return best;
  }
  Bounds bounds() const override {
    Bounds b = Shape().bounds();
    for (const Member& m : members) {
      const Bounds own = m.shape.bounds();
      b = {b.lower.cwiseMin(own.lower), b.upper.cwiseMax(own.upper)};
    }
    return b;
  }
  bool exact_outside() const override { return exact; }
  std::vector<Member> members;
  bool exact = true;
};

struct Intersection final : Shape::Node {
  explicit Intersection(const std::vector<Shape>& s) : shapes(s) {}
  double psi(const Vec<3>& x) const override {
    double least = infinity;
    for (const Shape& s : shapes) least = std::min(least, s.psi(x));
    return least;
  }
  Bounds bounds() const override {
    Bounds b = everywhere;
    for (const Shape& s : shapes) {
      const Bounds own = s.bounds();
      b = {b.lower.cwiseMax(own.lower), b.upper.cwiseMin(own.upper)};
    }
    return b;
  }
  bool exact_outside() const override { return false; }
  std::vector<Shape> shapes;
};

struct Complement final : Shape::Node {
  explicit Complement(const Shape& s) : shape(s) {}
  double psi(const Vec<3>& x) const override { return -shape.psi(x); }
  Bounds bounds() const override { return everywhere; }
  bool exact_outside() const override { return false; }
  Shape shape;
};

struct Translation final : Shape::Node {
  Translation(const Shape& s, const Vec<3>& d) : shape(s), by(d) {}
  double psi(const Vec<3>& x) const override { return shape.psi(x - by); }
  Bounds bounds() const override {
    const Bounds b = shape.bounds();
    return {b.lower + by, b.upper + by};
  }
  bool exact_outside() const override { return shape.exact_outside(); }
  Shape shape;
  Vec<3> by;
};

struct RotationZ final : Shape::Node {
  RotationZ(const Shape& s, double angle)
      : shape(s), cos_(std::cos(angle)), sin_(std::sin(angle)) {}
  double psi(const Vec<3>& x) const override {
    return shape.psi({cos_ * x[0] + sin_ * x[1], cos_ * x[1] - sin_ * x[0], x[2]});
  }
  Bounds bounds() const override {
    const Bounds b = shape.bounds();
    if ((b.lower.array() > b.upper.array()).any()) return b;
    Bounds turned = {{infinity, infinity, b.lower[2]}, {-infinity, -infinity, b.upper[2]}};
    for (const double x : {b.lower[0], b.upper[0]})
      for (const double y : {b.lower[1], b.upper[1]}) {
        if (!std::isfinite(x) || !std::isfinite(y))
          return {{-infinity, -infinity, b.lower[2]}, {infinity, infinity, b.upper[2]}};
        const Vec<3> corner(cos_ * x - sin_ * y, sin_ * x + cos_ * y, b.lower[2]);
        turned.lower.head<2>() = turned.lower.head<2>().cwiseMin(corner.head<2>());
        turned.upper.head<2>() = turned.upper.head<2>().cwiseMax(corner.head<2>());
      }
    return turned;
  }
  bool exact_outside() const override { return shape.exact_outside(); }
  Shape shape;
  double cos_, sin_;
};

}  // namespace

Shape unite(const std::vector<Shape>& shapes) { return Shape(std::make_shared<Union>(shapes)); }

Shape intersect(const std::vector<Shape>& shapes) {
  if (shapes.empty()) throw InputError("intersect: no shapes: expected at least one");
  return Shape(std::make_shared<Intersection>(shapes));
}

Shape subtract(const Shape& from, const Shape& what) { return intersect({from, complement(what)}); }

Shape complement(const Shape& shape) { return Shape(std::make_shared<Complement>(shape)); }

Shape translate(const Shape& shape, const Vec<3>& by) {
  if (!by.allFinite()) throw InputError("translate: the distance is not finite");
  return Shape(std::make_shared<Translation>(shape, by));
}

Shape rotate_z(const Shape& shape, double angle) {
  if (!std::isfinite(angle)) throw InputError("rotate_z: the angle is not finite");
  return Shape(std::make_shared<RotationZ>(shape, angle));
}

}  // namespace washtub
