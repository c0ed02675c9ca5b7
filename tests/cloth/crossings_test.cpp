#include "cloth/crossings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "sheets.hpp"

namespace washtub {
namespace {

constexpr Material cloth_of_any_kind{50, 20, 0.3, 0.2, 0, 0, 1e-3};

Mesh<2> square(bool periodic = false) {
  return {{0, 0}, {0.1, 0.1}, {20, 20}, {periodic, periodic}};
}
Mesh<3> cube(bool periodic = false) {
  return {{0, 0, 0}, {0.1, 0.1, 0.1}, {20, 20, 20}, {periodic, periodic, periodic}};
}

/// Two plates of 5 x 5 nodes, 0.1 m apart: one flat through the middle of the box, the other
/// upright across it. Nowhere do an edge of one and a node or an edge of the other meet.
std::vector<Vec<3>> plates_that_cross() {
  std::vector<Vec<3>> X;
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) X.emplace_back(0.8 + 0.1 * i, 0.8 + 0.1 * j, 1);
  for (int j = 0; j < 5; ++j)
    for (int i = 0; i < 5; ++i) X.emplace_back(0.757 + 0.1 * i, 1.013, 0.831 + 0.1 * j);
  return X;
}

Cloth<3> plates(const std::vector<Vec<3>>& X) {
  Cloth<3> cloth;
  cloth.add(make_plate({5, 5}, {0.1, 0.1}, cloth_of_any_kind), X);
  return cloth;
}

void expect_counts(const Crossings& found, long edges, long others, long own) {
  EXPECT_EQ(found.edges, edges);
  EXPECT_EQ(found.others, others);
  EXPECT_EQ(found.own, own);
}

/// The flat plate's columns of nodes at x = 0.8 to 1.1 pass through the upright one, which covers x
/// from 0.757 to 1.157, and that at 1.2 passes by. The upright plate's columns at 0.857 to 1.157
/// pass through the flat one; that at 0.757 passes by.
TEST(Crossings, OfTwoPlates) {
  const auto found = find_crossings(plates(plates_that_cross()), cube());
  expect_counts(found, 2 * 40, 4 + 4, 0);
  EXPECT_DOUBLE_EQ(found.share(), 0.1);
}

TEST(Crossings, DoNotDependOnPlaceAndDirection) {
  for (int turn = 1; turn < 20; ++turn) {
    auto X = plates_that_cross();
    const Eigen::AngleAxisd rotation(0.37 * turn, Vec<3>(1, turn % 3 - 1, 0.3).normalized());
    for (auto& x : X)
      x = rotation * (x - Vec<3>::Ones()) + Vec<3>(0.9, 1, 1.1) + 0.01 * turn * Vec<3>::Ones();
    expect_counts(find_crossings(plates(X), cube()), 80, 8, 0);
  }
}

/// Also where one of the plates is beyond a side, or has gone round the box several times.
TEST(Crossings, AcrossPeriodicSides) {
  for (const Vec<3>& way : {Vec<3>(1, 0, 0), Vec<3>(0.95, 1.02, -1.1), Vec<3>(-6, 9, 0.3)}) {
    auto X = plates_that_cross();
    for (std::size_t i = 0; i < X.size(); ++i)
      X[i] += way + (i < 25 ? Vec<3>(2, -4, 6) : Vec<3>(0, 0, -2));
    expect_counts(find_crossings(plates(X), cube(true)), 80, 8, 0);
    expect_counts(find_crossings(plates(X), cube()), 80, 0, 0);
  }
}

TEST(Crossings, PlatesThatOnlyTouchHaveNone) {
  auto X = plates_that_cross();
  for (std::size_t i = 25; i < 50; ++i) X[i][2] += 1 - 0.831;  // stands on the flat one
  expect_counts(find_crossings(plates(X), cube()), 80, 0, 0);
  X = plates_that_cross();
  for (std::size_t i = 0; i < 25; ++i) X[25 + i] = X[i];  // lies on it, node on node
  expect_counts(find_crossings(plates(X), cube()), 80, 0, 0);
  for (std::size_t i = 0; i < 25; ++i) X[25 + i] = X[i] + Vec<3>(0.05, 0.03, 0);  // in its plane
  expect_counts(find_crossings(plates(X), cube()), 80, 0, 0);
}

/// A plate folded over, whose last row of quads comes down again through the first.
TEST(Crossings, OfAPlateWithItself) {
  const auto sheet = make_plate({6, 4}, {0.1, 0.1}, cloth_of_any_kind);
  const double x[] = {1, 1.1, 1.2, 1.25, 1.16, 1.07}, z[] = {1, 1, 1, 1.08, 1.04, 0.96};
  std::vector<Vec<3>> X;
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 6; ++i) X.emplace_back(x[i], 1 + 0.1 * j + 0.013 * (i > 3), z[i]);
  Cloth<3> cloth;
  cloth.add(sheet, X);
  // The last edges of the columns at y = 1.013, 1.113 and 1.213 pass through the first row of
  // quads, that at 1.313 beside it; the first edges at y = 1.1, 1.2 and 1.3 through the last row.
  expect_counts(find_crossings(cloth, cube()), 5 * 4 + 6 * 3, 0, 3 + 3);
  auto flat = X;
  for (std::size_t i = 0; i < X.size(); ++i) flat[i] = testing::flat(sheet)[i] + Vec<3>::Ones();
  cloth.position = flat;
  expect_counts(find_crossings(cloth, cube()), 38, 0, 0);
}

TEST(Crossings, OfThreads) {
  const auto sheet = make_thread(5, 0.1, cloth_of_any_kind);
  std::vector<Vec<2>> X;
  for (int i = 0; i < 5; ++i) X.emplace_back(0.8 + 0.1 * i, 1);
  for (int i = 0; i < 5; ++i) X.emplace_back(1.03, 0.77 + 0.1 * i);
  Cloth<2> cloth;
  cloth.add(sheet, X);
  expect_counts(find_crossings(cloth, square()), 8, 2, 0);
  for (auto& x : cloth.position) x += Vec<2>(0.98, 0.95);
  for (std::size_t i = 0; i < 5; ++i) cloth.position[i] += Vec<2>(-2, 4);
  expect_counts(find_crossings(cloth, square(true)), 8, 2, 0);
  expect_counts(find_crossings(cloth, square()), 8, 0, 0);
  for (std::size_t i = 5; i < 10; ++i) cloth.position[i] = X[i - 5] + 0.1 * Vec<2>(0, i - 5);
  for (std::size_t i = 0; i < 5; ++i) cloth.position[i] = X[i];
  expect_counts(find_crossings(cloth, square()), 8, 0, 0);  // meet in a node only
}

/// A ring drawn to a figure of eight crosses itself once; its seam is an edge like the others.
TEST(Crossings, OfAClosedThreadWithItself) {
  const auto ring = make_thread(4, 0.1, cloth_of_any_kind, true);
  Cloth<2> cloth;
  cloth.add(ring, std::vector<Vec<2>>{{1, 1}, {1.1, 1.1}, {1.1, 1}, {1, 1.1}});
  expect_counts(find_crossings(cloth, square()), 4, 0, 2);
  cloth.position = {{1, 1}, {1.1, 1}, {1.1, 1.1}, {1, 1.1}};
  expect_counts(find_crossings(cloth, square()), 4, 0, 0);
}

/// A thread through the whole periodic box and a short one across its seam.
TEST(Crossings, AcrossTheSeamOfAPeriodicThread) {
  std::vector<Vec<2>> X;
  for (int i = 0; i < 10; ++i) X.emplace_back(0.13 + 0.2 * i, 1);
  Cloth<2> cloth;
  cloth.add(make_thread(10, 0.2, cloth_of_any_kind, true, {2, 0}), X);
  cloth.add(make_thread(3, 0.1, cloth_of_any_kind),
            std::vector<Vec<2>>{{0.04, 0.93}, {0.04, 1.03}, {0.04, 1.13}});
  expect_counts(find_crossings(cloth, square(true)), 12, 2, 0);
}

/// Two segments between random points of a square cross with probability 25/108 (Sylvester's
/// four points: convex with 25/36, and then one pairing of three crosses).
TEST(Crossings, OfRandomSegmentsAreAsManyAsTheyMustBe) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0, 1);
  Sheet<2> segment;
  segment.extent = {1, 2};
  segment.spacing = {0, 1};
  segment.area = {0.5, 0.5};
  long crossed = 0;
  constexpr long pairs = 4000;
  for (int n = 0; n < pairs; ++n) {
    std::vector<Vec<2>> X;
    for (int i = 0; i < 4; ++i) X.emplace_back(place(random), place(random));
    Cloth<2> cloth;
    cloth.add(segment, X);
    crossed += find_crossings(cloth, square()).others / 2;
  }
  EXPECT_NEAR(static_cast<double>(crossed) / pairs, 25.0 / 108, 0.02);  // three deviations
}

TEST(Crossings, AreNotCountedWhereThereIsNoPlace) {
  auto X = plates_that_cross();
  X[3][1] = std::nan("");
  expect_counts(find_crossings(plates(X), cube()), 0, 0, 0);
  EXPECT_EQ(find_crossings(plates(X), cube()).share(), 0);
}

}  // namespace
}  // namespace washtub
