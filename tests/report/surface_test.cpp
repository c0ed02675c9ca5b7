#include "report/surface.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>
#include <map>
#include <numbers>

namespace washtub {
namespace {

constexpr double pi = std::numbers::pi;
const SurfaceBox unit = {Vec<3>::Constant(-1), Vec<3>::Constant(1)};

Vec<3> vertex(const Surface& s, std::uint32_t n) {
  return Eigen::Map<const Eigen::Vector3f>(s.vertices[n].data()).cast<double>();
}

/// Twice the area times the unit normal.
Vec<3> normal(const Surface& s, const std::array<std::uint32_t, 3>& t) {
  return (vertex(s, t[1]) - vertex(s, t[0])).cross(vertex(s, t[2]) - vertex(s, t[0]));
}

double area(const Surface& s) {
  double sum = 0;
  for (const auto& t : s.triangles) sum += normal(s, t).norm() / 2;
  return sum;
}

/// Positive where triangles are counter-clockwise seen from outside.
double volume(const Surface& s) {
  double sum = 0;
  for (const auto& t : s.triangles) sum += vertex(s, t[0]).dot(normal(s, t)) / 6;
  return sum;
}

/// Edges that do not have one triangle on each side.
std::size_t open_edges(const Surface& s) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : s.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  std::size_t open = 0;
  for (const auto& [edge, count] : edges)
    if (count != 1 || !edges.contains({edge.second, edge.first})) ++open;
  return open;
}

/// What is said of everything that surface() makes.
void expect_fair(const Surface& s) {
  EXPECT_GT(s.triangles.size(), 100U);
  EXPECT_LE(s.triangles.size(), 20000U);
}

TEST(Surface, OfAThinPlate) {
  const Solid plate{
      "plate", box({-0.1, -0.1, -0.0001}, {0.1, 0.1, 0.0001}), {0.1, 0.2, 0.3}, at_rest()};
  EXPECT_TRUE(reaches_into(plate, unit));
  const auto s = surface(plate, unit);
  ASSERT_TRUE(s);
  EXPECT_NEAR(area(*s), 2 * 0.04, 0.002);
}

TEST(Surface, OfASphere) {
  const auto s = surface({"ball", sphere(Vec<3>::Zero(), 0.5), {0.1, 0.2, 0.3}, at_rest()}, unit);
  ASSERT_TRUE(s);
  expect_fair(*s);
  EXPECT_EQ(open_edges(*s), 0U);
  EXPECT_NEAR(area(*s), pi, 0.01 * pi);
  EXPECT_NEAR(volume(*s), pi / 6, 0.01 * pi / 6);
}

TEST(Surface, EdgesAreSharp) {
  const Vec<3> corner(0.31, 0.22, 0.13);
  const auto s = surface({"block", box(-corner, corner), Vec<3>::Zero(), constant_speed(1)}, unit);
  ASSERT_TRUE(s);
  EXPECT_EQ(open_edges(*s), 0U);
  EXPECT_NEAR(volume(*s), 8 * corner.prod(), 2e-3 * 8 * corner.prod());
  double farthest = 0;
  for (std::uint32_t n = 0; n < s->vertices.size(); ++n)
    farthest = std::max(farthest, (vertex(*s, n).cwiseAbs() - corner).maxCoeff());
  EXPECT_LT(farthest, 1e-3);
  double to_corner = 1;
  for (std::uint32_t n = 0; n < s->vertices.size(); ++n)
    to_corner = std::min(to_corner, (vertex(*s, n) - corner).norm());
  EXPECT_LT(to_corner, 2e-3);
}

TEST(Surface, MovingSolidIsClosedWhereTheFloorCutsIt) {
  const auto s = surface({"post", cylinder(0.3, -5, 0.5), Vec<3>::Zero(), constant_speed(1)}, unit);
  ASSERT_TRUE(s);
  expect_fair(*s);
  EXPECT_EQ(open_edges(*s), 0U);
  EXPECT_NEAR(volume(*s), pi * 0.09 * 1.5, 0.01 * pi * 0.09 * 1.5);
}

TEST(Surface, MovingSolidIsWholeWhereItLeavesTheBoxAtAngleZero) {
  const SurfaceBox narrow = {{-0.5, -2, -1}, {0.5, 2, 1}};
  const Solid bar = {"bar", box({-1, -0.1, -0.1}, {1, 0.1, 0.1}), Vec<3>::Zero(),
                     constant_speed(1)};
  const auto s = surface(bar, narrow);
  ASSERT_TRUE(s);
  EXPECT_NEAR(volume(*s), 0.08, 1e-3);
}

TEST(Surface, OfATubIsItsWallSeenFromInside) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Shape tub = complement(cylinder(0.8, -infinity, infinity));
  const auto s = surface({"tub", tub, Vec<3>::Zero(), at_rest()}, unit);
  ASSERT_TRUE(s);
  expect_fair(*s);
  EXPECT_NEAR(area(*s), 2 * pi * 0.8 * 2, 0.01 * 2 * pi * 0.8 * 2);
  for (const auto& t : s->triangles) {
    const Vec<3> n = normal(*s, t), x = vertex(*s, t[0]);
    if (n.norm() < 1e-5) continue;
    EXPECT_LT(n.head<2>().normalized().dot(x.head<2>().normalized()), -0.9);
  }
}

TEST(Surface, OfAPlaneCaseFillsTheSlab) {
  const SurfaceBox slab = {{-1, -1, -0.01}, {1, 1, 0}, true};
  const auto s = surface({"pin", sphere(Vec<3>::Zero(), 0.5), Vec<3>::Zero(), at_rest()}, slab);
  ASSERT_TRUE(s);
  expect_fair(*s);
  EXPECT_EQ(open_edges(*s), 0U);
  EXPECT_NEAR(volume(*s), pi / 4 * 0.01, 1e-4 * pi);
}

TEST(Surface, NoneWithoutASurfaceInTheBox) {
  EXPECT_FALSE(surface({"far", sphere({5, 0, 0}, 1), Vec<3>::Zero(), at_rest()}, unit));
  EXPECT_FALSE(surface({"nothing", Shape(), Vec<3>::Zero(), at_rest()}, unit));
  EXPECT_FALSE(surface({"all", sphere({0, 0, 0}, 9), Vec<3>::Zero(), at_rest()}, unit));
}

}  // namespace
}  // namespace washtub
