#include "solid/shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include "base/error.hpp"
#include "samples.hpp"

namespace washtub {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct Named {
  const char* name;
  Shape shape;
};

/// Bounded primitives inside the cube [-1.2, 1.2]^3, each with an exact distance.
std::vector<Named> primitives() {
  return {{"sphere", sphere({0.1, -0.2, 0.3}, 0.6)},
          {"cylinder", cylinder(0.5, -0.4, 0.8)},
          {"box", box({-0.5, -0.3, -0.7}, {0.4, 0.6, 0.2})},
          {"capsule", capsule({-0.4, 0.1, -0.3}, {0.5, 0.3, 0.4}, 0.25)},
          {"cone", revolution({{0, -0.5}, {0.8, -0.5}, {0.8, -0.3}, {0.2, 0.6}, {0, 0.6}})},
          {"ring", revolution({{0.4, -0.2}, {0.8, -0.2}, {0.8, 0.3}, {0.4, 0.3}})},
          {"plate", plate({{0, -0.6}, {0.7, -0.6}, {0.7, 0.1}, {0.2, 0.5}, {0, 0.5}}, 0.15)}};
}

std::vector<Named> combined() {
  const Shape a = sphere({0.1, 0, 0}, 0.5), b = box({-0.6, -0.2, -0.3}, {0.6, 0.2, 0.3});
  return {{"union", unite({a, translate(a, {0.3, 0.4, 0}), b})},
          {"intersection", intersect({a, b})},
          {"difference", subtract(a, b)},
          {"complement", complement(a)},
          {"rotated", rotate_z(b, 0.7)},
          {"half space", half_space({0.1, 0.2, 0.3}, {1, 2, 3})}};
}

/// Points where the segments between samples of opposite sign cross the surface.
std::vector<Vec<3>> surface_points(const Shape& shape, int count) {
  Points points(1.2);
  std::vector<Vec<3>> found;
  while (static_cast<int>(found.size()) < count) {
    Vec<3> in = points.next(), out = points.next();
    if (shape.psi(in) <= 0 || shape.psi(out) >= 0) continue;
    for (int i = 0; i < 32; ++i) {
      const Vec<3> middle = 0.5 * (in + out);
      (shape.psi(middle) > 0 ? in : out) = middle;
    }
    found.push_back(in);
  }
  return found;
}

double nearest(const std::vector<Vec<3>>& points, const Vec<3>& x) {
  double least = infinity;
  for (const Vec<3>& p : points) least = std::min(least, (p - x).norm());
  return least;
}

TEST(Shape, PrimitivesGiveTheDistanceToTheNearestSurfacePoint) {
  for (const auto& [name, shape] : primitives()) {
    const auto surface = surface_points(shape, 2500);
    Points points(1.2);
    for (int i = 0; i < 100; ++i) {
      const Vec<3> x = points.next();
      const double sampled = nearest(surface, x), exact = std::abs(shape.psi(x));
      EXPECT_LE(exact, sampled + 1e-9) << name << " at " << x.transpose();
      EXPECT_GE(exact, sampled - 0.12) << name << " at " << x.transpose();
    }
  }
}

TEST(Shape, StepAlongGradientLandsOnTheSurfaceOfPrimitives) {
  for (const auto& [name, shape] : primitives()) {
    Points points(1.2);
    int kinks = 0;
    for (int i = 0; i < 500; ++i) {
      const Vec<3> x = points.next();
      Vec<3> gradient;
      for (int k = 0; k < 3; ++k) {
        const Vec<3> e = 1e-6 * Vec<3>::Unit(k);
        gradient[k] = (shape.psi(x + e) - shape.psi(x - e)) / 2e-6;
      }
      const double landed = std::abs(shape.psi(x - shape.psi(x) * gradient));
      if (std::abs(gradient.norm() - 1) > 1e-5 || landed > 1e-5) ++kinks;
    }
    EXPECT_LE(kinks, 2) << name;
  }
}

TEST(Shape, IsLipschitzWithConstantOne) {
  auto shapes = primitives();
  for (const Named& extra : combined()) shapes.push_back(extra);
  for (const auto& [name, shape] : shapes) {
    Points points(1.2);
    for (int i = 0; i < 2000; ++i) {
      const Vec<3> x = points.next(), y = x + 0.2 * points.next();
      EXPECT_LE(std::abs(shape.psi(x) - shape.psi(y)), (x - y).norm() * (1 + 1e-12)) << name;
    }
  }
}

TEST(Shape, KnownDistances) {
  EXPECT_DOUBLE_EQ(cylinder(2, 0, 1).psi({0, 0, 0.25}), 0.25);
  EXPECT_DOUBLE_EQ(cylinder(2, 0, 1).psi({5, 0, 5}), -5);
  EXPECT_DOUBLE_EQ(cylinder(2, -infinity, infinity).psi({0, 0.5, 1e3}), 1.5);
  EXPECT_DOUBLE_EQ(half_space({0, 0, 1}, {0, 0, 4}).psi({7, 8, -2}), 3);
  EXPECT_DOUBLE_EQ(plate({{0, 0}, {2, 0}, {2, 2}, {0, 2}}, 0.5).psi({1, 0.25, 1}), 0.25);
  EXPECT_EQ(Shape().psi({0, 0, 0}), -infinity);
}

TEST(Shape, AxisOfARevolutionIsNoSurface) {
  const Shape solid = revolution({{0, -1}, {1, -1}, {1, 1}, {0, 1}});
  EXPECT_DOUBLE_EQ(solid.psi({0, 0, 0}), 1);
  EXPECT_DOUBLE_EQ(solid.psi({0, 0, 3}), -2);
}

TEST(Shape, PolygonMayTurnEitherWay) {
  const std::vector<Vec<2>> one = {{0, 0}, {1, 0}, {1, 1}}, other = {{1, 1}, {1, 0}, {0, 0}};
  for (const Vec<3>& x : {Vec<3>(0.7, 0, 0.3), Vec<3>(0.3, 0, 0.7)})
    EXPECT_DOUBLE_EQ(plate(one, 1).psi(x), plate(other, 1).psi(x));
}

TEST(Shape, UnionIsTheMaximumEverywhere) {
  std::vector<Shape> members;
  for (const Named& p : primitives()) members.push_back(p.shape);
  for (const Named& c : combined()) members.push_back(intersect({c.shape, members.front()}));
  const Shape united = unite(members);
  Points points(3);
  for (int i = 0; i < 3000; ++i) {
    const Vec<3> x = points.next();
    double largest = -infinity;
    for (const Shape& m : members) largest = std::max(largest, m.psi(x));
    EXPECT_EQ(united.psi(x), largest);
  }
}

TEST(Shape, DifferenceAndComplementHaveTheRightSign) {
  const Shape ball = sphere({0, 0, 0}, 1);
  const Shape shell = subtract(ball, sphere({0, 0, 0}, 0.5));
  EXPECT_LT(shell.psi({0, 0, 0.2}), 0);
  EXPECT_DOUBLE_EQ(shell.psi({0, 0, 0.75}), 0.25);
  EXPECT_DOUBLE_EQ(complement(ball).psi({0, 0, 3}), 2);
}

TEST(Shape, RotationTurnsCounterClockwiseSeenFromAbove) {
  const Shape arm = capsule({0, 0, 0}, {1, 0, 0}, 0.1);
  const Shape turned = rotate_z(arm, std::numbers::pi / 2);
  EXPECT_NEAR(turned.psi({0, 0.5, 0}), 0.1, 1e-15);
  EXPECT_LT(turned.psi({0.5, 0, 0}), 0);
}

TEST(Shape, BoundsHoldTheShape) {
  auto shapes = primitives();
  for (const Named& p : primitives()) shapes.push_back({p.name, rotate_z(p.shape, 0.4)});
  for (const auto& [name, shape] : shapes) {
    const Bounds b = shape.bounds();
    for (const Vec<3>& x : surface_points(shape, 200)) {
      EXPECT_TRUE((x.array() > b.lower.array() - 1e-9).all()) << name;
      EXPECT_TRUE((x.array() < b.upper.array() + 1e-9).all()) << name;
    }
  }
  EXPECT_GT(Shape().bounds().lower[0], Shape().bounds().upper[0]);
}

std::string message(const std::function<void()>& act) {
  try {
    act();
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Shape, ImpossibleParametersAreNamed) {
  using ::testing::HasSubstr;
  EXPECT_THAT(message([] { sphere({0, 0, 0}, -1); }), HasSubstr("sphere: radius = -1 m"));
  EXPECT_THAT(message([] { cylinder(1, 2, 1); }), HasSubstr("z_lower, z_upper = 2 m, 1 m"));
  EXPECT_THAT(message([] { revolution({{0, 0}, {-1, 0}, {0, 1}}); }), HasSubstr("vertex 2"));
  EXPECT_THAT(message([] { plate({{0, 0}, {1, 0}}, 1); }), HasSubstr("2 vertices"));
  EXPECT_THAT(message([] { half_space({0, 0, 0}, {0, 0, 0}); }), HasSubstr("normal"));
  EXPECT_THAT(message([] { intersect({}); }), HasSubstr("at least one"));
}

}  // namespace
}  // namespace washtub
