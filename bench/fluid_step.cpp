#include <benchmark/benchmark.h>

#include "support/wash_tub.hpp"

namespace washtub {
namespace {

/// A whole fluid step of the reference wash without cloth, agitator turning, Re 1200.
/// Arguments: cells per axis, 1e6 dt omega_max. Reports million cell-steps per second.
void fluid_step(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const double dt = 1e-6 * static_cast<double>(state.range(1)) / testing::peak_speed;
  testing::WashTub tub(n, 1.0);
  tub.t = 0.2;
  for (int i = 0; i < 20; ++i) tub.step(dt);
  double cycles = 0, steps = 0;
  for (auto _ : state) {
    cycles += tub.step(dt).pressure.cycles;
    ++steps;
  }
  const double cells = std::pow(n, 3);
  state.counters["Mcell_steps/s"] =
      benchmark::Counter(1e-6 * cells * steps, benchmark::Counter::kIsRate);
  state.counters["cycles"] = cycles / steps;
}
BENCHMARK(fluid_step)
    ->Args({32, 5000})
    ->Args({64, 500})
    ->Args({64, 5000})
    ->Args({128, 500})
    ->Args({128, 5000})
    ->Iterations(150)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace washtub
