#include "contact/pair.hpp"

#include <gtest/gtest.h>

#include <numeric>

#include "contact/geometry.hpp"
#include "support/dots.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

template <int D>
typename Pair<D>::Places places(std::uint64_t seed, double size = 1) {
  typename Pair<D>::Places x;
  for (std::size_t k = 0; k < x.size(); ++k)
    for (int d = 0; d < D; ++d)
      x[k][d] = size * scatter(100 * seed + 10 * k + static_cast<std::uint64_t>(d));
  return x;
}

/// The least distance over points of a raster on both parts.
template <int D>
double by_search(int split, const typename Pair<D>::Places& x) {
  constexpr int n = 60;
  double least = 1e30;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double s = double(i) / n, t = double(j) / n;
      Vec<D> gap;
      if (D == 2)
        gap = x[0] - (1 - s) * x[1] - s * x[2];
      else if (split == 2)
        gap = (1 - s) * x[0] + s * x[1] - (1 - t) * x[2] - t * x[D];
      else if (i + j > n)
        continue;
      else
        gap = x[0] - (1 - s - t) * x[1] - s * x[2] - t * x[D];
      least = std::min(least, gap.norm());
    }
  return least;
}

template <int D>
void expect_nearest(int split) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto x = places<D>(seed);
    const auto near = nearest<D>(split, x);
    const double d = near.gap.norm(), found = by_search<D>(split, x);
    EXPECT_LE(d, found + 1e-12);
    EXPECT_GT(d, found - 0.06);
    EXPECT_NEAR(std::accumulate(near.weight.begin(), near.weight.end(), 0.0), 0, 1e-12);
    Vec<D> gap = Vec<D>::Zero();
    for (std::size_t k = 0; k < x.size(); ++k) {
      gap += near.weight[k] * x[k];
      EXPECT_GE(static_cast<int>(k) < split ? near.weight[k] : -near.weight[k], 0);
    }
    EXPECT_LT((gap - near.gap).norm(), 1e-12);
  }
}

}  // namespace

TEST(Pair, FindsTheNearestPoints) {
  expect_nearest<2>(1);
  expect_nearest<3>(1);
  expect_nearest<3>(2);
}

TEST(Pair, KnowsParallelEdgesAndEdgesThatAreOne) {
  const Pair<3>::Places beside = {Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0.8, 0.3, 0),
                                  Vec<3>(5, 0.3, 0)};
  EXPECT_NEAR(nearest<3>(2, beside).gap.norm(), 0.3, 1e-12);
  const Pair<3>::Places behind = {Vec<3>(0, 0, 0), Vec<3>(1, 0, 0), Vec<3>(3, 0, 0),
                                  Vec<3>(2, 0, 0)};
  EXPECT_NEAR(nearest<3>(2, behind).gap.norm(), 1, 1e-12);
}

/// A point that falls onto a triangle, and two edges that pass each other crosswise.
TEST(Pair, MeetsWhenAnalysisSaysSo) {
  const Pair<3>::Places x = {Vec<3>(0.2, 0.2, 1), Vec<3>(0, 0, 0), Vec<3>(1, 0, 0),
                             Vec<3>(0, 1, 0)};
  Pair<3>::Places way{};
  for (auto& u : way) u = Vec<3>(3, 4, 5);  // the common motion does not matter
  way[0] += Vec<3>(0, 0, -2);
  const auto hit = find_impact<3>(1, x, way, 0.1);
  ASSERT_TRUE(hit);
  EXPECT_LE(hit->time, 0.45);
  EXPECT_GT(hit->time, 0.4494);
  EXPECT_LT((hit->normal - Vec<3>(0, 0, 1)).norm(), 1e-9);
  EXPECT_NEAR(hit->weight[1], -0.6, 1e-9);
  way[0] -= Vec<3>(0, 0, -1.2);
  EXPECT_FALSE(find_impact<3>(1, x, way, 0.1));
  const Pair<3>::Places edges = {Vec<3>(-1, 0, 0), Vec<3>(1, 0, 0), Vec<3>(0, -1, 1),
                                 Vec<3>(0, 1, 1)};
  Pair<3>::Places apart{};
  for (auto& u : apart) u.setZero();
  apart[0] = apart[1] = Vec<3>(0, 0, 4);
  const auto cross = find_impact<3>(2, edges, apart, 1e-3);
  ASSERT_TRUE(cross);
  EXPECT_NEAR(cross->time, 0.25, 3e-4);
}

/// However the parts move, none is nearer than `least` before the time found.
TEST(Pair, IsNeverLate) {
  const auto check = [](auto dimension, int split) {
    constexpr int D = decltype(dimension)::value;
    int hits = 0;
    for (std::uint64_t seed = 0; seed < 500; ++seed) {
      const auto x = places<D>(seed), way = places<D>(seed + 1000, 2);
      const double least = 0.5 * nearest<D>(split, x).gap.norm();
      const auto hit = find_impact<D>(split, x, way, least);
      hits += hit.has_value();
      for (int i = 0; i <= 50; ++i) {
        const double t = i / 50.0;
        if (hit && t >= hit->time) break;
        auto y = x;
        for (std::size_t k = 0; k < y.size(); ++k) y[k] += t * way[k];
        EXPECT_GE(nearest<D>(split, y).gap.norm(), least * (1 - 1e-9)) << seed << ' ' << t;
      }
    }
    EXPECT_GT(hits, 80);
    EXPECT_LT(hits, 490);
  };
  check(std::integral_constant<int, 2>(), 1);
  check(std::integral_constant<int, 3>(), 1);
  check(std::integral_constant<int, 3>(), 2);
}
