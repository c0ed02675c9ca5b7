#include <benchmark/benchmark.h>

#include "coupling/immersed_boundary.hpp"
#include "solid/mapping.hpp"
#include "washer/build.hpp"

namespace washtub {
namespace {

constexpr Kernel kernels[] = {Kernel::cosine, Kernel::roma3, Kernel::peskin4};

/// What goes from cloth to grid and back in the reference wash: 64^3 cells, 16 pieces where they
/// start, water between prediction and projection. Run from the project's root.
struct Wash {
  Case whole = read_case("cases/wash-3d/case.toml", {"domain.cells=64", "cloth.count=16"});
  Mesh<3> mesh = build_mesh<3>(whole);
  Grid<3> grid{mesh, Parallel(), granularity(mesh)};
  DomainMapping<3> mapping{grid, build_solids(whole), 0};
  Flow<3> flow{grid,
               whole.fluid.density,
               whole.fluid.viscosity,
               build_sides<3>(whole),
               {mapping.open(), false}};
  Cloth<3> cloth = build_cloth<3>(whole);
  ImmersedBoundary<3> boundary;
  std::vector<Vec<3>> nodes = cloth.position;  ///< some vectors at the nodes

  explicit Wash(Kernel kernel) : boundary(grid, cloth, kernel, build_sides<3>(whole)) {
    mapping.update(0.1);
    flow.openings_changed(0, grid.block().planes(), true);
    mapping.impose(flow.velocity());
    flow.predict(1e-4);
    boundary.place(cloth.position);
  }
};

/// Calls work(wash) again and again. Argument: the kernel.
template <class Work>
void measure(benchmark::State& state, Work&& work) {
  Wash wash(kernels[state.range(0)]);
  for (auto _ : state) work(wash);
}

void place(benchmark::State& state) {
  measure(state, [](Wash& w) { w.boundary.place(w.cloth.position); });
}
void spread(benchmark::State& state) {
  measure(state, [](Wash& w) { w.boundary.spread(w.nodes, w.flow.force()); });
}
void interpolate(benchmark::State& state) {
  measure(state, [](Wash& w) { w.boundary.interpolate(w.flow.velocity(), w.nodes); });
}
void interpolate_provisional(benchmark::State& state) {
  measure(state, [](Wash& w) { w.boundary.interpolate(w.flow.provisional(), w.nodes); });
}
void mobility(benchmark::State& state) {
  measure(state,
          [](Wash& w) { w.boundary.mobility(w.flow.openings(), w.flow.density(), w.nodes); });
}
void clear(benchmark::State& state) {
  measure(state, [](Wash& w) {
    for (auto& f : w.flow.force()) f.fill(0);
  });
}

BENCHMARK(place)->DenseRange(0, 2)->Unit(benchmark::kMicrosecond);
BENCHMARK(spread)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(interpolate)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(interpolate_provisional)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(mobility)->DenseRange(0, 1)->Unit(benchmark::kMicrosecond);
BENCHMARK(clear)->Arg(0)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace washtub
