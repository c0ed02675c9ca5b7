#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "base/snapshot.hpp"
#include "io/checkpoint.hpp"
#include "io/scratch.hpp"
#include "washer/simulation.hpp"

namespace washtub {
namespace {

constexpr int steps = 10;  // before and after the restart

/// Rows of the history, which cut steps, come at times that no step meets by itself.
template <int D>
void advance(Simulation<D>& simulation, double every) {
  for (int n = 0; n < steps; ++n)
    simulation.step(every * (1 + std::floor(simulation.time() / every + 1e-9)));
}

/// Largest difference of two states, NaN where one is.
template <int D>
double difference(const Simulation<D>& a, const Simulation<D>& b) {
  double largest = std::abs(a.time() - b.time()) + std::abs(a.work_on_cloth() - b.work_on_cloth());
  const auto& block = a.grid().block();
  for (int d = 0; d < D; ++d)
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (long p = block.row(j, k), end = p + block.width(); p < end; ++p) {
          largest += std::abs(a.flow().velocity()[d][p] - b.flow().velocity()[d][p]);
          largest += std::abs(a.flow().pressure()[p] - b.flow().pressure()[p]);
          largest += std::abs(a.mapping().open()[d][p] - b.mapping().open()[d][p]);
        }
  for (std::size_t i = 0; i < a.cloth().position.size(); ++i)
    largest += (a.cloth().position[i] - b.cloth().position[i]).norm();
  return largest;
}

struct Restart {
  const char* name;
  const char* path;
  std::vector<std::string> settings;
  bool cautious = false;  ///< the step is being cut when the checkpoint is written
};

class Restarts : public ::testing::TestWithParam<Restart> {};

/// A step that a restart would change shows in every number: the flow is not steady.
template <int D>
void goes_on(const Case& whole, bool cautious) {
  const Parallel parallel;
  const Scratch dir(Scratch::For::all_ranks);
  const Checkpoints ring(dir.path(), 1);
  const double every = 3.3 * (whole.time.step > 0 ? whole.time.step : whole.time.end / 500);
  Simulation<D> straight(whole, parallel), resumed(whole, parallel);
  advance(straight, every);
  if (cautious) straight.be_cautious(0.5);
  ring.write({"test", whole.resolved, straight.time(), straight.last().number}, parallel,
             [&](Archive& a) { a.value("simulation", straight); });
  MPI_Barrier(parallel.comm());
  StateReader(ring.list().at(0)).value("simulation", resumed);
  EXPECT_EQ(difference(straight, resumed), 0);
  Snapshot snapshot;
  snapshot.take(straight);
  advance(straight, every);
  advance(resumed, every);
  EXPECT_EQ(straight.last().number, resumed.last().number);
  EXPECT_EQ(straight.last().dt, resumed.last().dt);
  EXPECT_EQ(difference(straight, resumed), 0);
  for (std::size_t s = 0; s < whole.solids.size(); ++s)
    EXPECT_EQ(straight.take_impulse(s).moment, resumed.take_impulse(s).moment);
  snapshot.put_back(straight);
  advance(straight, every);
  EXPECT_EQ(difference(straight, resumed), 0);
}

TEST_P(Restarts, BitForBit) {
  const auto& p = GetParam();
  const Case whole = read_case(p.path, p.settings);
  if (whole.dimension == 2)
    goes_on<2>(whole, p.cautious);
  else
    goes_on<3>(whole, p.cautious);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, Restarts,
    ::testing::Values(Restart{"space",
                              "cases/wash-3d/case.toml",
                              {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]"}},
                      Restart{"spaceAfterACut",
                              "cases/wash-3d/case.toml",
                              {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]"},
                              true},
                      Restart{"spaceUnderLoad",
                              "cases/wash-3d/case.toml",
                              {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]",
                               "cloth.load=[\"1e4 * t\", \"0\", \"100 * x\"]"}},
                      Restart{"plane", "cases/wash-2d/case.toml", {"domain.cells=64"}},
                      Restart{"planeSmooth",
                              "cases/wash-2d/case.toml",
                              {"domain.cells=64", "domain.mapping=smooth"}},
                      Restart{"spaceGradual",
                              "cases/wash-3d/case.toml",
                              {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]",
                               "domain.mapping=gradual"}},
                      Restart{"planeExplicit",
                              "cases/wash-2d/case.toml",
                              {"domain.cells=64", "coupling.scheme=explicit", "time.step=20 us"}},
                      Restart{"planeBroyden",
                              "cases/wash-2d/case.toml",
                              {"domain.cells=64", "coupling.scheme=broyden", "time.step=50 us"}},
                      Restart{"outflowAndPins", "verification/filament/case.toml", {}},
                      Restart{"pinnedPlate", "verification/flag/case.toml", {}},
                      Restart{"outflow", "verification/cylinder/case.toml", {}}),
    [](const auto& info) { return info.param.name; });

/// What several ranks have written one rank takes up, to what the cloth's solve leaves: 1e-10 of a
/// node spacing, 4e-12 m, in each of twenty steps.
TEST(Restarts, OnAnotherNumberOfRanks) {
  const Case whole = read_case("cases/wash-3d/case.toml",
                               {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]"});
  const Parallel parallel;
  const Scratch dir(Scratch::For::all_ranks);
  const Checkpoints ring(dir.path(), 1);
  Simulation<3> straight(whole, parallel), resumed(whole, Parallel(MPI_COMM_SELF));
  advance(straight, 1);
  ring.write({"test", whole.resolved, straight.time(), straight.last().number}, parallel,
             [&](Archive& a) { a.value("simulation", straight); });
  MPI_Barrier(parallel.comm());
  StateReader(ring.list().at(0)).value("simulation", resumed);
  EXPECT_EQ(straight.time(), resumed.time());
  advance(straight, 1);
  advance(resumed, 1);
  double largest = 0;
  for (std::size_t i = 0; i < straight.cloth().position.size(); ++i)
    largest =
        std::max(largest, (straight.cloth().position[i] - resumed.cloth().position[i]).norm());
  EXPECT_LT(largest, 1e-9);
  EXPECT_NEAR(straight.last().kinetic, resumed.last().kinetic, 1e-7 * resumed.last().kinetic);
  const double moment = resumed.take_impulse(1).moment;
  EXPECT_NEAR(straight.take_impulse(1).moment, moment, 1e-6 * std::abs(moment));
}

/// Water and cloth are those of the other run; time, solids and viscosity this one's.
TEST(Developed, AnotherCaseStartsFromWaterAndCloth) {
  const Parallel parallel;
  const Scratch dir(Scratch::For::all_ranks);
  const Checkpoints ring(dir.path(), 1);
  std::vector<std::string> settings = {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]"};
  const Case first = read_case("cases/wash-3d/case.toml", settings);
  settings.insert(settings.end(), {"fluid.viscosity=2 Pa s", "washer.agitator.fins=4"});
  const Case second = read_case("cases/wash-3d/case.toml", settings);
  Simulation<3> before(first, parallel);
  advance(before, 1);
  ring.write({"test", first.resolved, before.time(), before.last().number}, parallel,
             [&](Archive& a) { a.value("simulation", before); });
  MPI_Barrier(parallel.comm());
  StateReader file(ring.list().at(0), "simulation/");
  Simulation<3> after(second, parallel, &file);
  EXPECT_EQ(after.time(), 0);
  EXPECT_EQ(after.last().number, 0);
  EXPECT_EQ(after.flow().viscosity(), 2);
  EXPECT_NEAR(after.last().kinetic, before.last().kinetic, 0.3 * before.last().kinetic);
  for (std::size_t i = 0; i < after.cloth().position.size(); ++i)
    EXPECT_EQ(after.cloth().position[i], before.cloth().position[i]);
  advance(after, 1);
  EXPECT_TRUE(after.finite());
}

}  // namespace
}  // namespace washtub
