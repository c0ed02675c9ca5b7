#include <gtest/gtest.h>

#include <numeric>

#include "coupling/pool.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

std::vector<int> all_nodes() {
  std::vector<int> nodes(9);
  std::iota(nodes.begin(), nodes.end(), 0);
  return nodes;
}

class Pinned : public ::testing::TestWithParam<Scheme> {};
INSTANTIATE_TEST_SUITE_P(Coupling, Pinned,
                         ::testing::Values(Scheme::implicit, Scheme::explicit_euler,
                                           Scheme::broyden));

}  // namespace

TEST_P(Pinned, ThreadStopsTheWaterThatMeetsIt) {
  Pool<2> pool(square(), 1, stretched_thread(1, 5, 200, all_nodes()), GetParam());
  const auto start = pool.cloth.position;
  pool.water.start_from([](int d, const Vec<2>&) { return d == 1 ? 0.5 : 0.0; });
  const Vec<2> before = pool.momentum();
  Vec<2> impulse = Vec<2>::Zero();
  double leak = 0;
  for (int i = 0; i < 60; ++i) {
    leak = pool.step(4e-3, 1e-7).leak;
    impulse += 4e-3 * pool.force();
  }
  EXPECT_EQ(pool.cloth.position, start);
  EXPECT_LT(leak, 0.01 * 0.5);
  EXPECT_LT(impulse[1], -20);  // of 500 kg m/s
  EXPECT_LT((pool.momentum() - before - impulse).norm(), 1e-6 * before.norm());
}

TEST_P(Pinned, NodeHoldsThreadInAStream) {
  Pool<2> pool(square(), 1, stretched_thread(1, 0.05, 5e4, {0, 1}), GetParam());
  const auto start = pool.cloth.position;
  pool.water.start_from([](int d, const Vec<2>&) { return d == 0 ? 0.5 : 0.1; });
  typename Coupling<2>::Report report;
  for (int i = 0; i < 400; ++i) {
    report = pool.step(5e-4);
    ASSERT_LT(report.largest_strain, 0.1) << i;
  }
  EXPECT_EQ(pool.cloth.position[0], start[0]);
  EXPECT_EQ(pool.cloth.position[1], start[1]);
  EXPECT_GT((pool.cloth.position[8] - start[8]).norm(), 0.005);
  EXPECT_LT(report.leak, 0.02 * 0.5);
  EXPECT_LT(report.slip, 0.02 * 0.5);
}

TEST_P(Pinned, NodesMayBeInsideASolidAndTheirNeighboursNearIt) {
  WaterBox<2> water({cubic_mesh<2>({0, 0}, 1, 32),
                     {{"post", capsule({0, 0, 0}, {0, 0.001, 0}, 0.12), {0.3, 0.5, 0}, at_rest()}},
                     1000,
                     1});
  std::vector<Vec<2>> where;
  for (int i = 0; i < 9; ++i)
    where.emplace_back(0.38 + 0.025 * i, 0.5);  // 1 of 9 is near, 2 inside
  Cloth<2> cloth;
  cloth.add(make_thread(9, 0.025, {5e3, 0, 1e-3, 0, 0, 0, 1e-3}), where, {0, 1});
  Coupling<2> coupling(water.flow, cloth, water.mapping, Kernel::cosine, {}, GetParam());
  for (int i = 0; i < 3; ++i) {
    water.move_solids(1e-3);
    water.flow.predict(1e-3);
    coupling.push();
    water.flow.project(1e-4, 60);
    EXPECT_FALSE(coupling.again());
    EXPECT_EQ(coupling.move().barrier.touched, 0);
  }
  for (std::size_t i = 0; i < 9; ++i) EXPECT_LT((cloth.position[i] - where[i]).norm(), 1e-12);
}
