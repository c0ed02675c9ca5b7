#include <benchmark/benchmark.h>

#include <cmath>
#include <numeric>
#include <random>
#include <vector>

#include "cloth/implicit.hpp"
#include "cloth/plate.hpp"
#include "cloth/thread.hpp"

/// One implicit solve of 16 pieces: cloth of the paper's Table 4 (Table 1 for threads) that a flow
/// has bent and pulled out of shape, with the ghost mass of the washer's grid.
namespace washtub {
namespace {

constexpr int pieces = 16;

template <int D>
struct Group {
  std::vector<int> owned = std::vector<int>(pieces);
  std::vector<Mat<D>> stiffness;
  std::vector<Vec<D>> target, Y, F;

  Group(int nodes, double k)
      : stiffness(pieces * nodes, k * Mat<D>::Identity()), Y(pieces * nodes), F(pieces * nodes) {
    std::iota(owned.begin(), owned.end(), 0);
  }
};

template <int D>
void measure(benchmark::State& state, const Sheet<D>& sheet, Group<D>& group) {
  ClothSolver<D> solver(sheet);
  typename ClothSolver<D>::Report report;
  for (auto _ : state)
    report = solver.solve(group.owned, {group.stiffness, group.target}, group.Y, group.F);
  state.counters["newton_steps"] = report.iterations;
  state.counters["factorisations_per_batch"] = report.factorisations * lanes / double(pieces);
  state.counters["failed"] = report.failed;
  state.counters["strain"] = report.largest_strain;
}

void plates(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const double ds = 0.15 / (n - 1), noise = 1e-4 * static_cast<double>(state.range(1)) * ds;
  const auto sheet = make_plate({n, n}, {ds, ds}, {8e5, 3e2, 1e-5, 1e-5, 0, 0, 2.4e-4});
  Group<3> group(n * n, 1000 * 1.1e-2 * 1.1e-2 * 0.37e-2 / (4e-4 * 4e-4));
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int p = 0; p < pieces; ++p) {
    for (int i = 0; i < n * n; ++i) {
      const double r = i % n * ds, s = i / n * ds, R = 0.05 + 0.01 * p;
      group.target.push_back({R * std::sin(r / R), s, R * std::cos(r / R)});
      for (int c = 0; c < 3; ++c) group.target.back()[c] += noise * normal(random);
    }
  }
  measure(state, sheet, group);
}

void threads(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const double ds = 0.2608 / (n - 1), noise = 1e-4 * static_cast<double>(state.range(1)) * ds;
  const auto sheet = make_thread(n, ds, {8e3, 0, 1e-5, 0, 0, 0, 2.4e-4});
  Group<2> group(n, 1000 * 1.1e-2 * 1.1e-2 / (4e-4 * 4e-4));
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int p = 0; p < pieces; ++p) {
    for (int i = 0; i < n; ++i) {
      const double s = i * ds, R = 0.05 + 0.01 * p;
      group.target.push_back({R * std::sin(s / R), R * std::cos(s / R)});
      for (int c = 0; c < 2; ++c) group.target.back()[c] += noise * normal(random);
    }
  }
  measure(state, sheet, group);
}

// nodes (along an edge), random displacement of the target in 1e-4 node spacings
BENCHMARK(plates)->ArgsProduct({{9, 14}, {1, 10, 100, 1000}})->Unit(benchmark::kMicrosecond);
BENCHMARK(threads)->ArgsProduct({{16, 48}, {10, 1000}})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace washtub
