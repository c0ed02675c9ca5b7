#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "cloth/cloth.hpp"
#include "cloth/stress.hpp"
#include "sheets.hpp"

namespace washtub {
namespace {

TEST(Closed, HasNoBorder) {
  const auto ring = testing::ring();
  EXPECT_NEAR(std::accumulate(ring.area.begin(), ring.area.end(), 0.0), 9 * 0.1, 1e-14);
  EXPECT_EQ(ring.inner.edges.size(), 9U);
  EXPECT_EQ(ring.inner.bends.size(), 9U);
  const auto tube = testing::tube(0), plate = testing::periodic_plate(0);
  EXPECT_NEAR(std::accumulate(tube.area.begin(), tube.area.end(), 0.0), 4 * 0.1 * 7 * 0.13, 1e-14);
  EXPECT_NEAR(std::accumulate(plate.area.begin(), plate.area.end(), 0.0), 5 * 0.1 * 4 * 0.13,
              1e-14);
  EXPECT_EQ(plate.inner.shears.size() + plate.seam.shears.size(), 20U);
  EXPECT_EQ(plate.seam.shears.size(), 4U + 5U - 1U);
}

/// A ring blown up by a factor has the energy of its n equal edges and bends, and a force that is
/// its derivative.
TEST(Closed, RingBreathes) {
  const auto ring = testing::ring();
  const Material& m = ring.material;
  const double factor = 1.2, ds = 0.1, n = 9, R = testing::circle_radius(9, ds);
  auto X = testing::flat(ring);
  for (auto& x : X) x *= factor;
  const double E = (factor * factor - 1) / 2;
  const double v = 2 * R * (1 - std::cos(2 * std::numbers::pi / n)) / (ds * ds);
  EXPECT_NEAR(ring.energy(X),
              n * ds * (m.stretch * E * E + m.bending * v * v * factor * factor) / 2, 1e-12);
  std::vector<Vec<2>> F(X.size());
  ring.force(X, F);
  const double slope = ds * factor * (m.stretch * E + m.bending * v * v) / R;
  for (std::size_t i = 0; i < X.size(); ++i)
    EXPECT_LT((F[i] + slope * X[i].normalized()).norm(), 1e-12 * slope);
}

template <int D>
void expect_at_rest_anywhere(const Sheet<D>& sheet) {
  auto X = testing::flat(sheet);
  for (auto& x : X) x += Vec<D>::LinSpaced(3, -2);
  std::vector<Vec<D>> F(X.size());
  sheet.force(X, F);
  for (const auto& f : F) EXPECT_LT(f.norm(), 1e-11);
  EXPECT_LT(sheet.energy(X), 1e-24);
}

TEST(Closed, PeriodicSheetRestsWhereverItIs) {
  expect_at_rest_anywhere(testing::periodic_thread());
  expect_at_rest_anywhere(testing::periodic_plate(0.3));
}

/// Where a closed thread is cut open does not matter.
template <class State>
void expect_seam_does_not_show(const Sheet<2>& sheet, const State& moved) {
  const auto X = testing::shaken(sheet, 0.02);
  std::vector<Vec<2>> Y(X.begin() + 1, X.end()), F(X.size()), G(X.size());
  Y.push_back(moved(X[0]));
  sheet.force(X, F);
  sheet.force(Y, G);
  EXPECT_NEAR(sheet.energy(X), sheet.energy(Y), 1e-12);
  for (std::size_t i = 0; i < X.size(); ++i)
    EXPECT_LT((G[i] - F[(i + 1) % X.size()]).norm(), 1e-11);
}

TEST(Closed, SeamDoesNotShow) {
  expect_seam_does_not_show(testing::ring(), [](const Vec<2>& x) { return x; });
  expect_seam_does_not_show(testing::periodic_thread(),
                            [](const Vec<2>& x) { return Vec<2>(x + Vec<2>(0.9, 0)); });
}

/// Bent to radius R all round.
TEST(Closed, StressOfRingIsTheSameEverywhere) {
  const double R = testing::circle_radius(9, 0.1), q = 1e-3;
  const auto ring = testing::ring();
  std::vector<NodeStress> out(9);
  Strains strains;
  const auto X = testing::flat(ring);
  find_strains<2>(ring, X, strains);
  find_stress(ring, X, strains, out);
  for (const auto& o : out) {
    EXPECT_NEAR(o.membrane, 0, 1e-9);
    EXPECT_NEAR(o.bending, 6 * 0.3 / R / (q * q), 1e-9 * o.bending);
  }
}

/// Pleats of one node spacing, sheared along r: every node sees the same.
TEST(Closed, StressOfPeriodicPlateDoesNotSeeItsSeams) {
  const auto plate = testing::periodic_plate(0.3);
  auto X = testing::flat(plate);
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i) {
      Vec<3>& x = X[plate.node(i, j)];
      x[2] = 0.02 * std::cos(std::numbers::pi * j);
      x[0] += 0.2 * x[2];
    }
  std::vector<NodeStress> out(20);
  Strains strains;
  find_strains<3>(plate, X, strains);
  find_stress(plate, X, strains, out);
  for (const auto& o : out) {
    EXPECT_GT(o.component[2], 0);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(o.component[c], out[7].component[c], 1e-6 * o.total);
  }
}

TEST(Closed, AreaWithinARing) {
  std::vector<Vec<2>> square = {{5, 5}, {7, 5}, {7, 8}, {5, 8}};
  EXPECT_DOUBLE_EQ(enclosed_area(square), 6);
  std::reverse(square.begin(), square.end());
  EXPECT_DOUBLE_EQ(enclosed_area(square), -6);
}

TEST(Cloth, RemembersWhatIsPinned) {
  const auto thread = testing::thread();
  const auto X = testing::flat(thread);
  Cloth<2> cloth;
  cloth.add(thread, X, {0, 8});
  cloth.add(thread, X);
  EXPECT_EQ(cloth.groups[0].pinned, (std::vector<int>{0, 8}));
  EXPECT_TRUE(cloth.groups[1].pinned.empty());
  EXPECT_EQ(cloth.groups[1].first_node, 9);
}

}  // namespace
}  // namespace washtub
