#include "contact/held_pairs.hpp"

#include <gtest/gtest.h>

#include "contact/heap.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

constexpr double gap = 0.01, k = 50;

/// Loose nodes: each goes where the forces on it take it, some ways more easily than others.
template <int D>
struct Loose {
  Cloth<D> cloth;
  ClothSurface<D> surface;
  PairList<D> list;
  HeldPairs<D> held;
  std::vector<Vec<D>> free, next, push;
  std::vector<Mat<D>> yield;
  std::vector<char> pushed;

  Loose(const Cloth<D>& cloth_, double friction)
      : cloth(cloth_),
        surface(cloth),
        list(surface, open_box<D>(), 0.02, Share(Parallel())),
        held(surface, Parallel(), gap, {{friction}}),
        free(cloth.position),
        push(free.size(), Vec<D>::Zero()),
        pushed(free.size(), 0) {
    for (std::size_t i = 0; i < free.size(); ++i) {
      const Vec<D> n =
          Vec<D>(Vec<D>::Ones() + 0.2 * static_cast<double>(i) * Vec<D>::UnitX()).normalized();
      yield.push_back((Mat<D>::Identity() + 2 * n * n.transpose()) / (k * (1 + 0.5 * scatter(i))));
    }
  }

  /// Rounds of holding and moving until nothing has to be held any more; returns how many.
  int settle() {
    held.start();
    next = free;
    for (int round = 0; round < 50; ++round) {
      std::fill(pushed.begin(), pushed.end(), 0);
      HeldStep<D> step{1e-3, cloth.position, next, yield, push, pushed};
      list.cover(cloth.position, next, gap);
      held.hold(list, cloth.position, next, step);
      if (std::count(pushed.begin(), pushed.end(), 1) == 0) return round;
      for (std::size_t i = 0; i < next.size(); ++i) next[i] = free[i] + yield[i] * push[i];
    }
    return 50;
  }
};

template <int D>
void expect_held(double friction) {
  Loose<D> loose(heap<D>(5, 0.02), friction);
  const auto ways = random_ways<D>(loose.free.size(), 0.004, 5);
  const auto n = loose.free.size() / 5;
  for (std::size_t i = 0; i < loose.free.size(); ++i) {
    loose.free[i] += ways[i];
    // All towards the middle one.
    loose.free[i][D - 1] -= 0.008 * (static_cast<double>(i / n) - 2);
  }
  ASSERT_LT(least_gap(loose.surface, loose.free), 0.7 * gap);
  EXPECT_LT(loose.settle(), 50);
  EXPECT_GT(least_gap(loose.surface, loose.next), 0.8 * gap);
  Vec<D> sum = Vec<D>::Zero();
  double all = 0;
  for (const auto& f : loose.push) sum += f, all += f.norm();
  EXPECT_GT(all, 0);
  EXPECT_LT(sum.norm(), 1e-13 * all);
}

}  // namespace

TEST(HeldPairs, KeepsAGapByForcesThatAddUpToNothing) {
  for (const double friction : {0.0, 0.5}) {
    expect_held<2>(friction);
    expect_held<3>(friction);
  }
}

TEST(HeldPairs, DoesNothingWhereAllKeepApart) {
  Loose<3> loose(heap<3>(5, 0.02), 0.5);
  for (auto& x : loose.free) x += Vec<3>(1, 2, 3);
  EXPECT_EQ(loose.settle(), 0);
  EXPECT_EQ(loose.held.count(), 0);
}

/// Pairs that are nearer than the gap widen step by step until they are not.
TEST(HeldPairs, RecoversALostGap) {
  Loose<2> loose(heap<2>(2, 0.002), 0);
  for (int step = 0; step < 100; ++step) {
    const double before = least_gap(loose.surface, loose.cloth.position);
    std::fill(loose.push.begin(), loose.push.end(), Vec<2>::Zero());
    loose.settle();
    const double after = least_gap(loose.surface, loose.next);
    ASSERT_GT(after, std::min(0.85 * gap, before));
    loose.cloth.position = loose.free = loose.next;
  }
  EXPECT_GT(least_gap(loose.surface, loose.cloth.position), 0.9 * gap);
}

/// One thread pressed on another and drawn along it: with much friction both go together, without
/// each goes its own way, with little it is Coulomb's.
TEST(HeldPairs, RubsByCoulombsLaw) {
  const auto slid = [](double friction) {
    Loose<2> loose(heap<2>(2, 0.011), friction);
    for (auto& yield : loose.yield) yield = Mat<2>::Identity() / k;
    for (std::size_t i = 6; i < 12; ++i) loose.free[i] += Vec<2>(0.002, -0.005);
    loose.settle();
    Vec<2> on_upper = Vec<2>::Zero();
    double way = 0;
    for (std::size_t i = 6; i < 12; ++i) on_upper += loose.push[i];
    for (std::size_t i = 0; i < 6; ++i) way += (loose.next[i + 6][0] - loose.next[i][0] - 0.03) / 6;
    return std::array{way, -on_upper[0] / on_upper[1]};
  };
  EXPECT_NEAR(slid(0)[0], 0.002, 1e-12);
  EXPECT_NEAR(slid(0)[1], 0, 1e-12);
  EXPECT_NEAR(slid(0.1)[1], 0.1, 1e-6);
  EXPECT_GT(slid(0.1)[0], 0.001);
  EXPECT_LT(slid(5)[0], 0.0006);
}
