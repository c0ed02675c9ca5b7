#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"
#include "washer/build.hpp"
#include "washer/placement.hpp"

namespace washtub {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
constexpr double pi = std::numbers::pi;

/// A box of 1 m with one thread of 0.4 m from its middle.
Case thread_case() {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {32, 32, 1};
  ClothCase cloth;
  cloth.arrangement = Arrangement::sheet;
  cloth.size = {0.4, 0};
  cloth.nodes = {9, 1};
  cloth.origin = {0.3, 0.5, 0};
  cloth.material = {100, 0, 1e-3, 0, 0, 0, 1e-3};
  whole.cloth = {cloth};
  return whole;
}

Case plate_case() {
  Case whole = thread_case();
  whole.dimension = 3;
  whole.domain.size = {1, 1, 1};
  whole.domain.cells = {32, 32, 32};
  whole.cloth[0].size = {0.4, 0.2};
  whole.cloth[0].nodes = {9, 5};
  whole.cloth[0].origin = {0.3, 0.5, 0.5};
  return whole;
}

/// Of the circle through three points in the plane, signed: positive if they turn to the left.
double curvature(const Vec<2>& a, const Vec<2>& b, const Vec<2>& c) {
  const Vec<2> p = b - a, q = c - b;
  return 2 * (p.x() * q.y() - p.y() * q.x()) / (p.norm() * q.norm() * (c - a).norm());
}

std::string error_of(const Case& whole) {
  try {
    check_build(whole);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

TEST(Arc, HasItsLengthAndCurvature) {
  Case whole = thread_case();
  whole.cloth[0].curvature = 4;
  const auto cloth = build_cloth<2>(whole);
  const auto& x = cloth.position;
  EXPECT_LT((x[0] - Vec<2>(0.3, 0.5)).norm(), 1e-15);
  for (std::size_t i = 0; i + 1 < 9; ++i) EXPECT_NEAR((x[i + 1] - x[i]).norm(), 0.05, 1e-15);
  for (std::size_t i = 0; i + 2 < 9; ++i)
    EXPECT_NEAR(curvature(x[i], x[i + 1], x[i + 2]), 4, 1e-12);
  EXPECT_NEAR(cloth.groups[0].sheet.largest_strain(x), 0, 1e-14);
}

TEST(Arc, OfASheetBendsAlongItsFirstEdgeOnly) {
  Case whole = plate_case();
  whole.cloth[0].curvature = -2;
  const auto cloth = build_cloth<3>(whole);
  const auto& x = cloth.position;
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_LT((x[i + 36] - x[i] - Vec<3>(0, 0.2, 0)).norm(), 1e-15);
    EXPECT_NEAR((x[i] - Vec<3>(0.3, 0.5, 0)).norm(), 0.5, 1e-14);  // circle below the start
  }
}

TEST(Arc, RandomOnesKeepTheirClearanceOnAnyGrid) {
  Case whole = thread_case();
  whole.solids = {{"hub", sphere({0.5, 0.5, 0}, 0.1), Vec<3>::Zero(), at_rest()}};
  ClothCase& group = whole.cloth[0];
  group.arrangement = Arrangement::random;
  group.count = 8;
  group.curvature = 4;
  group.clearance = 0.02;
  group.nodes = {41, 1};
  const auto fine = build_cloth<2>(whole);
  for (int p = 0; p < 8; ++p)
    for (const Vec<2>& x : fine.piece(fine.groups[0], p)) {
      EXPECT_GT((x - Vec<2>(0.5, 0.5)).norm(), 0.12 - 5e-5);
      EXPECT_GT(x.minCoeff(), 0.02 - 1e-6);
      EXPECT_LT(x.maxCoeff(), 0.98 + 1e-6);
      for (int q = 0; q < p; ++q)
        for (const Vec<2>& y : fine.piece(fine.groups[0], q))
          EXPECT_GT((x - y).norm(), 0.02 - 1e-6);
    }
  group.nodes = {11, 1};
  const auto coarse = build_cloth<2>(whole);
  for (int p = 0; p < 8; ++p)
    EXPECT_LT((coarse.piece(coarse.groups[0], p)[10] - fine.piece(fine.groups[0], p)[40]).norm(),
              2e-3 * 0.4);  // coarse chords reach further
}

TEST(Ring, IsRoundAndClosed) {
  Case whole = thread_case();
  ClothCase& ring = whole.cloth[0];
  ring.arrangement = Arrangement::ring;
  ring.centre = {0.5, 0.5, 0};
  ring.radius = 0.2;
  ring.size = {0.4 * pi, 0};
  ring.nodes = {32, 1};
  const auto round = build_cloth<2>(whole);
  EXPECT_EQ(round.groups[0].sheet.intervals(1), 32);
  for (const Vec<2>& x : round.position) EXPECT_NEAR((x - Vec<2>(0.5, 0.5)).norm(), 0.2, 1e-14);
  EXPECT_LT(round.groups[0].sheet.largest_strain(round.position), 2e-3);  // chords under arcs
  ring.ripple = 0.05;
  ring.ripples = 2;
  const auto oval = build_cloth<2>(whole);
  EXPECT_LT((oval.position[0] - Vec<2>(0.75, 0.5)).norm(), 1e-14);
  EXPECT_LT((oval.position[8] - Vec<2>(0.5, 0.65)).norm(), 1e-14);
}

TEST(ClosedSheet, SpansThePeriodicBox) {
  Case whole = plate_case();
  whole.domain.sides[0].kind = whole.domain.sides[1].kind = SideKind::periodic;
  ClothCase& sheet = whole.cloth[0];
  sheet.closed = {true, false};
  sheet.origin = {0, 0.4, 0.5};
  sheet.size = {0.9, 0.2};  // stretched to the box
  sheet.nodes = {10, 5};
  sheet.ripple = 0.01;
  const auto cloth = build_cloth<3>(whole);
  const auto& s = cloth.groups[0].sheet;
  EXPECT_NEAR(s.spacing[0], 0.09, 1e-15);
  EXPECT_TRUE(s.closed[0]);
  EXPECT_LT((s.period[0] - Vec<3>::UnitX()).norm(), 1e-15);
  EXPECT_NEAR(cloth.position[9].x(), 0.9, 1e-15);
  EXPECT_NEAR(cloth.position[3].z(), 0.5 + 0.01 * std::sin(0.6 * pi), 1e-15);
}

TEST(HeldEdges, PinsHoldOneRowAndClampsTwo) {
  Case whole = thread_case();
  whole.cloth[0].pinned = {Edge::r_upper};
  const auto pinned = build_cloth<2>(whole);
  EXPECT_THAT(pinned.groups[0].pinned, ElementsAre(8));
  EXPECT_NEAR(pinned.groups[0].sheet.spacing[1], 0.05, 1e-15);

  whole.cloth[0].pinned = {};
  whole.cloth[0].clamped = {Edge::r_lower};
  const auto clamped = build_cloth<2>(whole);
  EXPECT_THAT(clamped.groups[0].pinned, ElementsAre(0, 1));
  const double ds = 0.4 / 7.5;
  EXPECT_NEAR(clamped.groups[0].sheet.spacing[1], ds, 1e-15);
  EXPECT_NEAR(clamped.position[0].x(), 0.3 - ds / 2, 1e-15);  // the clamp is at 0.3
  EXPECT_NEAR(clamped.position[8].x(), 0.7, 1e-15);

  Case plate = plate_case();
  plate.cloth[0].pinned = {Edge::s_lower};
  EXPECT_EQ(build_cloth<3>(plate).groups[0].pinned.size(), 9u);
}

TEST(HeldEdges, MayStandInASolidAtRest) {
  Case whole = thread_case();
  whole.solids = {{"post", sphere({0.25, 0.5, 0}, 0.06), Vec<3>::Zero(), at_rest()}};
  EXPECT_THAT(error_of(whole), HasSubstr("the sheet touches solid \"post\""));
  whole.cloth[0].pinned = {Edge::r_lower};
  EXPECT_EQ(error_of(whole), "no error");
  whole.solids[0].drive = constant_speed(1);  // it would turn under the pin
  EXPECT_THAT(error_of(whole), HasSubstr("the sheet touches solid \"post\""));
  whole.solids[0].drive = at_rest();
  whole.cloth[0].origin = {0.21, 0.5, 0};  // the next node, too
  EXPECT_THAT(error_of(whole), HasSubstr("the sheet touches solid \"post\""));
}

}  // namespace
}  // namespace washtub
