#include "speed/suite.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <chrono>
#include <memory>
#include <regex>

#include "coupling/immersed_boundary.hpp"
#include "solid/loads.hpp"
#include "speed/washes.hpp"
#include "washer/build.hpp"
#include "washer/simulation.hpp"

namespace washtub {
namespace {

constexpr std::size_t vector_length = 8'000'000;  // three times 64 MB, more than caches hold
constexpr double begin_at = 0.05;                 // when steps are timed: the drive moves [s]
constexpr double value = sizeof(double);

// What each kernel has to move at least, per cell: every field once, in double precision.
constexpr double triad_bytes = 3 * value;
/// Velocity, its last rate of change in and out, u*: three components each.
constexpr double prediction_bytes = 3 * 4 * value;
/// Pressure in and out and source in double precision; in single precision the residual and the
/// correction, each in and out, the diagonal, and twice the open fractions of three faces.
constexpr double cycle_bytes = 3 * value + (2 + 2 + 1 + 2 * 3) * 0.5 * value;
/// Velocity in and out, force, and source and pressure of a projection.
constexpr double correction_bytes = (3 * 3 + 2) * value;

/// Times `act` on all ranks together; `between` is left out.
template <class Act, class Between>
void repeat(benchmark::State& state, const Parallel& parallel, Act&& act, Between&& between) {
  for (auto _ : state) {
    MPI_Barrier(parallel.comm());
    const auto start = std::chrono::steady_clock::now();
    act();
    const double own =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    state.SetIterationTime(parallel.max(own));
    between();
  }
}

void note(benchmark::State& state, double cells, double bytes) {
  state.counters["cells"] = cells;
  state.counters["bytes"] = bytes;
}

/// Long vectors, each rank its share: how fast memory is.
void triad(benchmark::State& state, const Parallel& parallel) {
  const std::size_t n = vector_length / static_cast<std::size_t>(parallel.size());
  std::vector<double> a(n, 0), b(n, 1), c(n, 2);
  repeat(
      state, parallel,
      [&] {
        double *x = a.data(), *y = b.data(), *z = c.data();
#pragma omp simd
        for (std::size_t i = 0; i < n; ++i) x[i] = y[i] + 3 * z[i];
        benchmark::ClobberMemory();
      },
      [] {});
  note(state, 0, triad_bytes * static_cast<double>(vector_length));
}

/// What a step is made of, taken from the reference wash.
struct Parts {
  Parts(int cells, const Parallel& parallel)
      : whole(reference_wash(3, cells, true)),
        grid(build_mesh<3>(whole), parallel, granularity(build_mesh<3>(whole))),
        mapping(grid, build_solids(whole), build_heaviside(whole)),
        flow(grid, whole.fluid.density, whole.fluid.viscosity, build_sides<3>(whole),
             {mapping.open(), mapping.held()}),
        cloth(build_cloth<3>(whole)),
        boundary(grid, cloth, whole.coupling.kernel, build_sides<3>(whole)),
        force(cloth.position.size(), Vec<3>(1e-3, 1e-3, 1e-3)),
        velocity(cloth.position.size()) {
    boundary.place(cloth.position);
    for (int i = 0; i < 20; ++i) {
      move();
      flow.predict(dt());
      project();
    }
  }

  double dt() const { return whole.time.step; }
  double cells() const {
    return static_cast<double>(whole.domain.cells[0]) * whole.domain.cells[1] *
           whole.domain.cells[2];
  }
  void move() {
    time += dt();
    const auto change = mapping.update(begin_at + time);
    const auto [k0, k1] = mapping.moving_planes();
    if (change.any) flow.openings_changed(k0, k1, change.flipped);
    mapping.impose(flow.velocity());
  }
  void project() {
    cycles += flow.project(whole.solver.divergence, whole.solver.max_cycles).pressure.cycles;
    ++projections;
  }
  WaterState<3> water() const {
    WaterState<3> w{{}, flow.pressure().data(), {}, flow.density(), flow.viscosity()};
    for (int d = 0; d < 3; ++d) {
      w.velocity[d] = flow.velocity()[d].data();
      w.force[d] = flow.force()[d].data();
    }
    return w;
  }

  Case whole;
  Grid<3> grid;
  DomainMapping<3> mapping;
  Flow<3> flow;
  Cloth<3> cloth;
  ImmersedBoundary<3> boundary;
  std::vector<Vec<3>> force, velocity;
  double time = 0;
  int cycles = 0, projections = 0;
};

using Kernel = void (*)(benchmark::State&, Parts&);

void solids(benchmark::State& state, Parts& p) {
  repeat(
      state, p.grid.parallel(), [&] { p.move(); }, [] {});
  note(state, p.cells(), 0);
}

void prediction(benchmark::State& state, Parts& p) {
  repeat(
      state, p.grid.parallel(), [&] { p.flow.predict(p.dt()); },
      [&] {
        p.project();
        p.move();
      });
  note(state, p.cells(), prediction_bytes * p.cells());
}

void projection(benchmark::State& state, Parts& p) {
  p.flow.predict(p.dt());
  const int cycles = p.cycles, projections = p.projections;
  repeat(
      state, p.grid.parallel(), [&] { p.project(); },
      [&] {
        p.move();
        p.flow.predict(p.dt());
      });
  p.project();
  const double each = static_cast<double>(p.cycles - cycles) / (p.projections - projections);
  note(state, p.cells(), (each * cycle_bytes + correction_bytes) * p.cells());
}

void place(benchmark::State& state, Parts& p) {
  repeat(
      state, p.grid.parallel(), [&] { p.boundary.place(p.cloth.position); }, [] {});
  note(state, 0, 0);
}

void spread(benchmark::State& state, Parts& p) {
  repeat(
      state, p.grid.parallel(), [&] { p.boundary.spread(p.force, p.flow.force()); }, [] {});
  for (auto& component : p.flow.force()) component.fill(0);
  note(state, 0, 0);
}

void interpolate(benchmark::State& state, Parts& p) {
  repeat(
      state, p.grid.parallel(), [&] { p.boundary.interpolate(p.flow.velocity(), p.velocity); },
      [] {});
  note(state, 0, 0);
}

void loads(benchmark::State& state, Parts& p) {
  repeat(
      state, p.grid.parallel(),
      [&] { benchmark::DoNotOptimize(surface_loads<3>(p.grid, p.mapping, 1, p.water())); }, [] {});
  note(state, 0, 0);
}

template <int D>
void step(benchmark::State& state, const Parallel& parallel, int cells, bool cloth) {
  const Case whole = reference_wash(D, cells, cloth);
  Simulation<D> simulation(whole, parallel);
  for (int i = 0; i < 20; ++i) simulation.step(whole.time.end);
  repeat(
      state, parallel, [&] { simulation.step(whole.time.end); }, [] {});
  note(state, std::pow(cells, D), 0);
}

/// Takes up the results instead of printing them.
class Collector : public benchmark::BenchmarkReporter {
 public:
  explicit Collector(std::vector<Speed>& results) : results_(results) {}
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs) {
      const auto counter = [&](const char* name) { return run.counters.at(name).value; };
      results_.push_back({run.run_name.function_name,
                          run.real_accumulated_time / static_cast<double>(run.iterations),
                          counter("cells"), counter("bytes")});
    }
  }

 private:
  std::vector<Speed>& results_;
};

/// Those of the measurements that are asked for.
class Suite {
 public:
  Suite(const Parallel& parallel, const std::regex& filter) : parallel_(parallel), filter_(filter) {
    benchmark::ClearRegisteredBenchmarks();
    add("triad", 10, [this](benchmark::State& state) { triad(state, parallel_); });
    add_kernels(64);
    add_steps();
  }
  ~Suite() { benchmark::ClearRegisteredBenchmarks(); }
  Suite(const Suite&) = delete;
  Suite& operator=(const Suite&) = delete;

  std::vector<Speed> run() const {
    std::vector<Speed> results;
    Collector collector(results);
    if (any_) benchmark::RunSpecifiedBenchmarks(&collector, "all");
    return results;
  }

 private:
  /// As many calls on all ranks.
  template <class Measure>
  void add(const std::string& name, int calls, Measure measure) {
    if (!std::regex_search(name, filter_)) return;
    benchmark::RegisterBenchmark(name.c_str(), measure)->Iterations(calls)->UseManualTime();
    any_ = true;
  }

  void add_kernels(int cells) {
    const std::pair<const char*, Kernel> kernels[] = {
        {"solids", solids}, {"prediction", prediction}, {"projection", projection},
        {"place", place},   {"spread", spread},         {"interpolate", interpolate},
        {"loads", loads}};
    for (const auto& [name, kernel] : kernels)
      add(fmt::format("{}, {}^3", name, cells), 30,
          [this, cells, kernel = kernel](benchmark::State& state) {
            if (!parts_) parts_ = std::make_unique<Parts>(cells, parallel_);
            kernel(state, *parts_);
          });
  }

  void add_steps() {
    const auto in_space = [this](int cells, bool cloth, int calls) {
      add(fmt::format("step, {}^3{}", cells, cloth ? " with 16 pieces" : ""), calls,
          [=, this](benchmark::State& s) { step<3>(s, parallel_, cells, cloth); });
    };
    in_space(32, false, 100);
    in_space(32, true, 100);
    in_space(64, false, 30);
    in_space(64, true, 30);
    add("step, 128^2 with 20 pieces", 200,
        [this](benchmark::State& s) { step<2>(s, parallel_, 128, true); });
  }

  const Parallel& parallel_;
  const std::regex& filter_;
  std::unique_ptr<Parts> parts_;  ///< made by the first kernel that needs them
  bool any_ = false;
};

}  // namespace

std::vector<Speed> measure_speeds(const Parallel& parallel, const std::regex& filter) {
  return Suite(parallel, filter).run();
}

}  // namespace washtub
