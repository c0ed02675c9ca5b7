#include "washer/placement.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "base/error.hpp"

using namespace washtub;
using ::testing::AllOf;
using ::testing::HasSubstr;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
constexpr std::array<int, 2> nodes = {9, 9};

/// The 3-D wash of the paper with `count` pages.
Case wash(int count, std::uint64_t seed = 1) {
  Case whole = read_case("cases/wash-3d/case.toml");
  whole.cloth[0].count = count;
  whole.cloth[0].seed = seed;
  return whole;
}

/// Threads at random in a round tub with a disc in its middle.
Case flat_wash(int count) {
  Case whole;
  whole.dimension = 2;
  whole.domain.lower = {-0.35, -0.35, 0};
  whole.domain.size = {0.7, 0.7, 0};
  whole.solids = {{"tub", complement(cylinder(0.32, -inf, inf)), Vec<3>::Zero(), at_rest()},
                  {"hub", cylinder(0.05, -inf, inf), Vec<3>::Zero(), at_rest()}};
  ClothCase cloth;
  cloth.count = count;
  cloth.size = {0.2, 0};
  cloth.arrangement = Arrangement::random;
  cloth.clearance = 0.01;
  whole.cloth = {cloth};
  return whole;
}

/// One sheet of 0.2 m x 0.1 m in a unit box with a ball in its middle.
Case sheet_case(const Vec<3>& origin) {
  Case whole;
  whole.domain.size = {1, 1, 1};
  whole.solids = {{"ball", sphere({0.5, 0.5, 0.5}, 0.2), Vec<3>::Zero(), at_rest()}};
  ClothCase cloth;
  cloth.size = {0.2, 0.1};
  cloth.arrangement = Arrangement::sheet;
  cloth.origin = origin;
  whole.cloth = {cloth};
  return whole;
}

/// Nodes of the pieces of the first group, 9 x 9 or 11 each.
std::vector<Vec<3>> place(const Case& whole) {
  ClothCase cloth = whole.cloth[0];
  if (cloth.nodes[0] == 0) cloth.nodes = whole.dimension == 3 ? nodes : std::array<int, 2>{11, 1};
  std::vector<Vec<3>> where;
  for (const Patch& patch : place_cloth(cloth, whole, {}))
    for (const Vec<3>& x : node_places(patch, cloth, whole)) where.push_back(x);
  return where;
}

/// Piece p as the rectangle that its corners span.
Rectangle piece(const std::vector<Vec<3>>& where, int p) {
  const auto x = where.begin() + p * nodes[0] * nodes[1];
  const int last = nodes[0] * (nodes[1] - 1);
  return {x[0], {x[nodes[0] - 1] - x[0], x[last] - x[0]}};
}

double largest_psi(const Case& whole, const std::vector<Vec<3>>& where) {
  double largest = -inf;
  for (const SolidCase& s : whole.solids)
    for (const Vec<3>& x : where)
      largest = std::max(largest, Solid{s.name, s.shape, s.centre, s.drive}.psi(x, 0));
  return largest;
}

std::string error_of(const Case& whole) {
  try {
    place(whole);
  } catch (const InputError& e) {
    return e.what();
  }
  return "no error";
}

}  // namespace

TEST(Rectangles, KnowTheirDistance) {
  const Rectangle a{{0, 0, 0}, {Vec<3>(2, 0, 0), Vec<3>(0, 2, 0)}};
  const Rectangle above{{0.5, 0.5, 0.3}, {Vec<3>(1, 0, 0), Vec<3>(0, 1, 0)}};
  const Rectangle piercing{{1, 1, -1}, {Vec<3>(0, 0.5, 0), Vec<3>(0, 0, 2)}};
  const Rectangle beside{{3, 0, 4}, {Vec<3>(0, 2, 0), Vec<3>(0, 0, 1)}};
  EXPECT_NEAR(distance(a, above), 0.3, 1e-15);
  EXPECT_EQ(distance(a, piercing), 0);
  EXPECT_NEAR(distance(a, beside), std::sqrt(17.0), 1e-14);
  EXPECT_NEAR(distance(Segment{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0)},
                       Segment{Vec<3>(0.4, -1, 0.2), Vec<3>(0.4, 1, 0.2)}),
              0.2, 1e-15);
  EXPECT_NEAR(distance(Segment{Vec<3>(0, 0, 0), Vec<3>(1, 0, 0)},
                       Segment{Vec<3>(3, 1, 0), Vec<3>(2, 1, 0)}),
              std::sqrt(2.0), 1e-15);
}

TEST(Book, HasPagesOfTheRightSizeAtTheirAngles) {
  Case whole = wash(16);
  whole.cloth[0].shift = whole.cloth[0].tilt = 0;
  const auto where = place(whole);
  ASSERT_EQ(where.size(), 16u * 81);
  for (int p = 0; p < 16; ++p) {
    const Vec<3> outwards(std::cos(pi * p / 8), std::sin(pi * p / 8), 0);
    const Rectangle page = piece(where, p);
    EXPECT_LT((page.corner - (0.148 * outwards + 0.078 * Vec<3>::UnitZ())).norm(), 1e-12);
    EXPECT_LT((page.edge[0] - 0.15 * outwards).norm(), 1e-12);
    EXPECT_LT((page.edge[1] - 0.15 * Vec<3>::UnitZ()).norm(), 1e-12);
  }
}

TEST(Book, KeepsItsClearanceForAnyNumberOfPages) {
  for (const int count : {16, 32, 64}) {
    const Case whole = wash(count);
    const double clearance = whole.cloth[0].clearance;
    const auto where = place(whole);
    EXPECT_LE(largest_psi(whole, where), -clearance + 2e-5);
    for (const Vec<3>& x : where) {
      EXPECT_GE(x[2], clearance);
      EXPECT_LE(x[2], 0.2376 - clearance + 1e-12);
    }
    for (int p = 0; p < count; ++p)
      for (int q = 0; q < p; ++q)
        EXPECT_GE(distance(piece(where, p), piece(where, q)), clearance * (1 - 1e-9));
  }
}

TEST(Book, FollowsFromItsSeed) {
  const auto one = place(wash(16, 1)), again = place(wash(16, 1)), other = place(wash(16, 2));
  EXPECT_EQ(one, again);
  EXPECT_GT((one[0] - other[0]).norm(), 1e-4);
  EXPECT_LT((one[0] - Vec<3>(0.14625963872, -0.00072593562, 0.08236050470)).norm(), 1e-10);
}

TEST(Book, ShiftsAndTiltsAsMuchAsAsked) {
  Case whole = wash(8);
  whole.solids.clear();
  whole.domain.size[2] = 1;  // nothing in the way
  whole.cloth[0].clearance = 0;
  double shift = 0, tilt = 0;
  for (std::uint64_t seed = 1; seed <= 64; ++seed) {
    whole.cloth[0].seed = seed;
    const auto where = place(whole);
    for (int p = 0; p < 8; ++p) {
      shift += std::pow(piece(where, p).centre()[2] - 0.153, 2) / 512;
      tilt += std::pow(piece(where, p).edge[0][2] / 0.15, 2) / 512;
    }
  }
  EXPECT_NEAR(std::sqrt(shift), whole.cloth[0].shift, 0.1 * whole.cloth[0].shift);
  EXPECT_NEAR(std::sqrt(tilt), whole.cloth[0].tilt, 0.1 * whole.cloth[0].tilt);
}

TEST(Book, OfTwoGroupsIsOneBook) {
  Case whole = wash(8);
  whole.cloth.push_back(whole.cloth[0]);
  std::vector<Patch> placed;
  for (const ClothCase& group : whole.cloth)
    for (const Patch& patch : place_cloth(group, whole, placed)) placed.push_back(patch);
  for (std::size_t p = 0; p < 8; ++p)
    for (std::size_t q = 8; q < 16; ++q)
      EXPECT_FALSE(near(facets(placed[p]), facets(placed[q]), 0.004 * (1 - 1e-9)));
}

TEST(Book, SaysWhyItHasNoPlace) {
  Case whole = wash(16);
  whole.cloth[0].inner_radius = 0.02;
  EXPECT_THAT(error_of(whole),
              AllOf(HasSubstr("piece 1 of 16: no free place"), HasSubstr("solid \"agitator\""),
                    HasSubstr("try a smaller cloth.count")));
}

TEST(RandomPieces, KeepTheirClearance) {
  const Case whole = flat_wash(20);
  const auto where = place(whole);
  ASSERT_EQ(where.size(), 220u);
  for (int p = 0; p < 20; ++p) {
    EXPECT_NEAR((where[11 * p + 10] - where[11 * p]).norm(), 0.2, 1e-12);
    for (int i = 0; i < 11; ++i) {
      EXPECT_GE(where[11 * p + i].norm(), 0.06 - 4e-5);
      EXPECT_LE(where[11 * p + i].norm(), 0.31 + 4e-5);
      for (int q = 0; q < 11 * p; ++q) EXPECT_GE((where[11 * p + i] - where[q]).norm(), 0.01);
    }
  }
}

TEST(RandomPieces, SayWhenTheTubIsFull) {
  EXPECT_THAT(error_of(flat_wash(300)),
              AllOf(HasSubstr("of 300: no free place"), HasSubstr("0.01 m to other pieces")));
}

TEST(RandomPieces, PointAnywhereInSpace) {
  Case whole = wash(40);
  whole.solids.clear();
  whole.cloth[0].arrangement = Arrangement::random;
  whole.cloth[0].size = {0.04, 0.02};
  const auto where = place(whole);
  Vec<3> squares = Vec<3>::Zero();
  for (int p = 0; p < 40; ++p) {
    const Rectangle r = piece(where, p);
    EXPECT_NEAR(r.edge[0].norm(), 0.04, 1e-12);
    EXPECT_NEAR(r.edge[0].dot(r.edge[1]), 0, 1e-15);
    squares += r.edge[0].cwiseAbs2() / (40 * 0.04 * 0.04);
  }
  for (int d = 0; d < 3; ++d) EXPECT_NEAR(squares[d], 1.0 / 3, 0.15);
}

TEST(SingleSheet, LiesWhereTheCasePutsIt) {
  Case whole = sheet_case({0.1, 0.2, 0.3});
  whole.cloth[0].along = {Vec<3>::UnitZ(), Vec<3>::UnitX()};
  const auto where = place(whole);
  EXPECT_LT((where[0] - Vec<3>(0.1, 0.2, 0.3)).norm(), 1e-15);
  EXPECT_LT((where[8] - Vec<3>(0.1, 0.2, 0.5)).norm(), 1e-15);
  EXPECT_LT((where[72] - Vec<3>(0.2, 0.2, 0.3)).norm(), 1e-15);
}

TEST(SingleSheet, IsRefusedWhereItCannotBe) {
  EXPECT_THAT(error_of(sheet_case({0.4, 0.45, 0.5})),
              HasSubstr("piece 1: the sheet touches solid \"ball\"; try another cloth.origin"));
  EXPECT_THAT(error_of(sheet_case({0.9, 0.5, 0.1})), HasSubstr("touches the upper x side"));
  EXPECT_THAT(error_of(sheet_case({0.1, 0.1, -0.1})), HasSubstr("touches the floor"));
}

TEST(SingleSheet, IsToldTheSideByWhatItIs) {
  Case whole = sheet_case({0.1, 0.1, 0.95});
  whole.cloth[0].along[1] = Vec<3>::UnitZ();
  EXPECT_THAT(error_of(whole), HasSubstr("touches the upper z side"));
  whole.domain.sides[5].kind = SideKind::slip;
  EXPECT_THAT(error_of(whole), HasSubstr("touches the water surface"));
  whole.cloth[0].origin[2] = -0.05;
  whole.domain.sides[4].kind = SideKind::slip;
  EXPECT_THAT(error_of(whole), HasSubstr("touches the lower z side"));
}

TEST(SingleSheet, MayCrossAPeriodicSide) {
  Case whole = sheet_case({0.9, 0.5, 0.1});
  whole.domain.sides[0].kind = whole.domain.sides[1].kind = SideKind::periodic;
  EXPECT_NEAR(place(whole)[8][0], 1.1, 1e-15);
}
