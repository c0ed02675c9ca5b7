#include "contact/barrier.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "support/dots.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double h = 1.0 / 16, speed = 2;

/// A unit box, periodic along x, with a turning disc in its middle.
struct Room {
  Grid<2> grid;
  DomainMapping<2> mapping;

  static Mesh<2> mesh() { return {{0, 0}, {h, h}, {16, 16}, {true, false}}; }
  static Solid disc() {
    return {"disc", cylinder(0.2, -inf, inf), {0.5, 0.5, 0}, constant_speed(speed)};
  }
  Room() : grid(mesh(), Parallel(), {1, 1}), mapping(grid, {disc()}) { mapping.update(0); }
};

/// Where a node at x is not too near any more.
Vec<2> moved_off(const Barrier<2>::Touch& touch, const Vec<2>& x) {
  return x - touch.excess * touch.normal;
}

double psi(const Vec<2>& x) { return 0.2 - (x - Vec<2>(0.5, 0.5)).norm(); }

}  // namespace

TEST(Barrier, LeavesNodesAloneThatKeepTheirDistance) {
  const Room room;
  const std::vector<Vec<2>> start = {
      {0.1, 0.5}, {0.5, 0.9}, {0.5 + 0.2 + 0.51 * h, 0.5}, {-3, 0.1}};
  Barrier<2> barrier(room.grid, room.mapping, dots(start));
  auto X = start;
  EXPECT_TRUE(barrier.find(X, 0.01).empty());
  const auto report = barrier.accept(X, 0.01);
  EXPECT_EQ(X, start);
  EXPECT_EQ(report.touched, 0);
  EXPECT_EQ(report.depth, 0);
  EXPECT_EQ(report.penetration, 0);
}

TEST(Barrier, PutsNodesHalfACellBeforeTheSurface) {
  const Room room;
  const std::vector<Vec<2>> start = {{0.5, 0.8}, {0.1, 0.1}, {0.1, 0.9}, {0.3, 0.9}};
  Barrier<2> barrier(room.grid, room.mapping, dots(start));
  std::vector<Vec<2>> X = {{0.53, 0.66}, {0.15, -0.2}, {0.12, 1.1}, {0.3, 0.85}};
  const auto contacts = barrier.find(X, 0.1);
  ASSERT_EQ(contacts.size(), 3u);
  EXPECT_EQ(contacts[0].node, 0);
  EXPECT_EQ(contacts[0].surface, 0);
  EXPECT_LT(contacts[1].surface, 0);
  const auto report = barrier.accept(X, 0.1);
  EXPECT_EQ(report.touched, 3);
  EXPECT_NEAR(report.depth, 0.2, 1e-12);  // of the floor; the disc: 0.04
  EXPECT_EQ(report.penetration, 0);
  EXPECT_NEAR(psi(X[0]), -0.5 * h, 1e-9);
  EXPECT_NEAR((X[0] - Vec<2>(0.5, 0.5)).normalized().dot(Vec<2>(0.03, 0.16).normalized()), 1, 1e-6);
  EXPECT_LT((X[0] - moved_off(contacts[0], {0.53, 0.66})).norm(), 1e-9);
  EXPECT_LT((X[1] - Vec<2>(0.15, 0.5 * h)).norm(), 1e-12);
  EXPECT_LT((X[2] - Vec<2>(0.12, 1 - 0.5 * h)).norm(), 1e-12);
  EXPECT_EQ(X[3], Vec<2>(0.3, 0.85));
}

/// Nodes that are held where find() says were deep before, and are not inside any more.
TEST(Barrier, ReportsTheDepthBeforeNodesWereHeld) {
  const Room room;
  std::vector<Vec<2>> X = {{0.5, 0.8}, {0.1, 0.1}};
  Barrier<2> barrier(room.grid, room.mapping, dots(X));
  X = {{0.5, 0.67}, {0.15, 0.01}};
  for (int round = 0; round < 3; ++round)
    for (const auto& contact : barrier.find(X, 0.1))
      X[contact.node] = moved_off(contact, X[contact.node]);
  const auto report = barrier.accept(X, 0.1);
  EXPECT_NEAR(report.depth, 0.03, 1e-9);  // of the disc; the other node stays above the floor
  EXPECT_EQ(report.penetration, 0);
  EXPECT_EQ(barrier.accept(X, 0.1).depth, 0);  // each step has its own
}

/// A node between a solid and a side that leave no room for it stays inside one of them.
TEST(Barrier, ReportsWhatIsLeftInside) {
  Grid<2> grid(Room::mesh(), Parallel(), {1, 1});
  const Solid lid{"lid", box({-inf, 0.02, -inf}, {inf, 0.2, inf}), Vec<3>::Zero(), at_rest()};
  DomainMapping<2> mapping(grid, {lid});
  std::vector<Vec<2>> X = {{0.5, 0.5}};
  Barrier<2> barrier(grid, mapping, dots(X));
  X[0][1] = 0.015;
  const auto report = barrier.accept(X, 0.1);
  EXPECT_EQ(report.depth, 0);
  EXPECT_GT(report.penetration, 0);
}

TEST(Barrier, LetsNodesThatStartNearStayButNotGoDeeper) {
  const Room room;
  const std::vector<Vec<2>> start = {{0.5, 0.2 * h}};
  Barrier<2> barrier(room.grid, room.mapping, dots(start));
  std::vector<Vec<2>> X = {{0.5, 0.15 * h}};
  barrier.accept(X, 0.01);
  EXPECT_NEAR(X[0][1], 0.2 * h, 1e-12);
  X[0][1] = 0.4 * h;  // on its way out
  barrier.accept(X, 0.01);
  EXPECT_NEAR(X[0][1], 0.4 * h, 1e-12);
  X[0][1] = 0.3 * h;
  barrier.accept(X, 0.01);
  EXPECT_NEAR(X[0][1], 0.4 * h, 1e-12);
}

/// A node closes by exp(-t/tau) of its gap, whatever the step.
TEST(Barrier, LetsNodesNearSoftlyWhateverTheStep) {
  constexpr double tau = 6e-3, end = 12e-3, start = 0.95 * h;
  for (const int steps : {3, 12, 48}) {
    const Room room;
    std::vector<Vec<2>> X = {{0.5, start}};
    Barrier<2> barrier(room.grid, room.mapping, dots(X), tau);
    for (int i = 0; i < steps; ++i) {
      X[0][1] = 0;
      const auto found = barrier.find(X, end / steps);
      ASSERT_EQ(found.size(), 1u);
      X[0] = moved_off(found[0], X[0]);
      barrier.accept(X, end / steps);
    }
    EXPECT_NEAR(X[0][1], 0.5 * h + (start - 0.5 * h) * std::exp(-end / tau), 1e-9) << steps;
  }
}

TEST(Barrier, FindsNodesThatComeFromFarInSmallSteps) {
  const Room room;
  std::vector<Vec<2>> X = {{0.05, 0.5}};
  Barrier<2> barrier(room.grid, room.mapping, dots(X));
  for (int step = 0; step < 100; ++step) {
    X[0][0] += 0.003;
    barrier.accept(X, 0.01);
    ASSERT_LE(psi(X[0]), -0.5 * h + 1e-9);
  }
  EXPECT_NEAR(X[0][0], 0.3 - 0.5 * h, 1e-6);
}

TEST(Barrier, MovesNodesOutOfTheWayOfAFin) {
  Grid<2> grid(Room::mesh(), Parallel(), {1, 1});
  const Solid fin{
      "fin", capsule({0, 0, 0}, {0.4, 0, 0}, 0.04), {0.5, 0.5, 0}, constant_speed(speed)};
  DomainMapping<2> mapping(grid, {fin});
  mapping.update(0);
  std::vector<Vec<2>> X = {{0.5, 0.75}};
  Barrier<2> barrier(grid, mapping, dots(X));
  for (int step = 1; step <= 100; ++step) {
    mapping.update(0.01 * step);
    barrier.accept(X, 0.01);
    ASSERT_LE(fin.psi({X[0][0], X[0][1], 0}, 0.01 * step), -0.5 * h + 1e-9) << step;
  }
  EXPECT_LT(X[0][0], 0.45);  // swept along
}

/// A body beside a periodic side: its image keeps nodes off on the other side, and so does the body
/// itself where a node passes the side.
TEST(Barrier, KeepsOffWhatIsBeyondAPeriodicSide) {
  const auto at = [](double x) {
    return Solid{"disc", cylinder(0.2, -inf, inf), {x, 0.5, 0}, at_rest()};
  };
  const Grid<2> grid(Room::mesh(), Parallel(), {1, 1});
  const DomainMapping<2> across(grid, {at(0.95), at(-0.05)}), near(grid, {at(0.7)});
  Barrier<2> image(grid, across, dots<2>({{0.3, 0.5}}));
  const std::vector<Vec<2>> in_image = {{0.16, 0.5}}, past_side = {{-0.08, 0.5}};
  ASSERT_EQ(image.find(in_image, 0.01).size(), 1u);
  EXPECT_NEAR(moved_off(image.find(in_image, 0.01)[0], in_image[0])[0], 0.15 + 0.5 * h, 1e-9);
  Barrier<2> body(grid, near, dots<2>({{0.05, 0.5}}));
  ASSERT_EQ(body.find(past_side, 0.01).size(), 1u);
  EXPECT_NEAR(moved_off(body.find(past_side, 0.01)[0], past_side[0])[0], -0.1 + 0.5 * h, 1e-9);
}
