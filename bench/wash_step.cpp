#include <benchmark/benchmark.h>

#include <string>

#include "washer/simulation.hpp"

namespace washtub {
namespace {

/// A whole step of the reference wash after half a stroke. Arguments: cells per axis, pieces of
/// cloth (0: water alone). The difference is what cloth costs. Run from the project's root.
void wash_step(benchmark::State& state) {
  const std::string cells = std::to_string(state.range(0)), count = std::to_string(state.range(1));
  const Case whole =
      read_case("cases/wash-3d/case.toml", {"domain.cells=" + cells, "cloth.count=" + count});
  Simulation<3> simulation(whole, Parallel());
  const double start = state.range(0) > 32 ? 0.05 : 0.4;
  while (simulation.time() < start) simulation.step(start);
  double steps = 0;
  for (auto _ : state) {
    simulation.step(1);
    ++steps;
  }
  const double million_cells = 1e-6 * static_cast<double>(state.range(0)) *
                               static_cast<double>(state.range(0)) *
                               static_cast<double>(state.range(0));
  state.counters["Mcell_steps/s"] =
      benchmark::Counter(million_cells * steps, benchmark::Counter::kIsRate);
}
BENCHMARK(wash_step)
    ->Args({32, 0})
    ->Args({32, 16})
    ->Args({64, 0})
    ->Args({64, 16})
    ->Args({128, 16})
    ->Iterations(100)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace washtub
