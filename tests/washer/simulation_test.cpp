#include "washer/simulation.hpp"

#include <gtest/gtest.h>

#include "cloth/thread.hpp"

namespace washtub {
namespace {

/// The reference wash on a coarse grid with a few pieces.
Case small_wash(const std::vector<std::string>& more = {}) {
  std::vector<std::string> settings = {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]"};
  settings.insert(settings.end(), more.begin(), more.end());
  return read_case("cases/wash-3d/case.toml", settings);
}

void run_to(Simulation<3>& simulation, double end) {
  while (simulation.time() < end - 1e-9) simulation.step(end);
}

/// Beyond round-off: on this grid a quarter of the nodes touch solids from the start, and what
/// binds them, 1e4 times as stiff as they are, leaves 1e-12 m in each solve, which fifty steps
/// amplify.
TEST(Simulation, DoesNotDependOnTheRanks) {
  const Case whole = small_wash();
  Simulation<3> serial(whole, Parallel(MPI_COMM_SELF)), parallel(whole, Parallel());
  run_to(serial, 0.02);
  run_to(parallel, 0.02);
  EXPECT_EQ(serial.last().number, parallel.last().number);
  double largest = 0;
  for (std::size_t i = 0; i < serial.cloth().position.size(); ++i)
    largest = std::max(largest, (serial.cloth().position[i] - parallel.cloth().position[i]).norm());
  EXPECT_LT(largest, 1e-7);
  EXPECT_NEAR(serial.last().kinetic, parallel.last().kinetic, 1e-6 * serial.last().kinetic);
  const Impulse a = serial.take_impulse(1), b = parallel.take_impulse(1);
  EXPECT_NEAR(a.moment, b.moment, 1e-6 * std::abs(a.moment));
  EXPECT_NEAR(a.squared, b.squared, 1e-6 * a.squared);
  EXPECT_NEAR(a.work, b.work, 1e-6 * std::abs(a.work));
}

TEST(Simulation, ClothStaysOutOfSolidsAndMovesWithTheWater) {
  Simulation<3> simulation(small_wash(), Parallel());
  double slip = 0;
  while (simulation.time() < 0.1) {
    const auto& step = simulation.step(0.1);
    EXPECT_TRUE(step.pressure.converged);
    EXPECT_LE(step.divergence, 1e-4);
    EXPECT_EQ(step.cloth.barrier.penetration, 0);
    EXPECT_LT(step.cloth.barrier.depth, 0.5 * simulation.grid().mesh().h.minCoeff());
    slip += step.cloth.slip / step.speed;
  }
  EXPECT_LT(slip / static_cast<double>(simulation.last().number), 0.01);
  for (const auto& x : simulation.cloth().position)
    for (const auto& solid : simulation.mapping().poses()) EXPECT_LT(solid.psi(x), 0);
}

/// The drive does work on the water: its torque is against the turning, and what it hands over in
/// the first tenth of a second is more than the kinetic energy then present, but of that order.
TEST(Simulation, DriveDoesTheWork) {
  Simulation<3> simulation(small_wash(), Parallel());
  double work = 0;
  while (simulation.time() < 0.1 - 1e-9) {
    simulation.step(0.1);
    work -= simulation.take_impulse(1).work;
  }
  EXPECT_GT(work, simulation.last().kinetic);
  EXPECT_LT(work, 4 * simulation.last().kinetic);
}

/// What is looked at after many steps is the sum of what is looked at after each.
TEST(Simulation, ImpulsesAreSumsOverTheSteps) {
  Simulation<3> often(small_wash(), Parallel()), once(small_wash(), Parallel());
  Impulse sum;
  while (often.time() < 0.02 - 1e-9) {
    once.step(0.02);
    const double dt = often.step(0.02).dt;
    const Impulse i = often.take_impulse(1);
    EXPECT_NEAR(i.time, dt, 1e-15);
    EXPECT_NEAR(i.squared, i.moment * i.moment / dt, 1e-12 * i.squared);
    EXPECT_NEAR(i.work, i.moment * i.angle / dt, 1e-12 * std::abs(i.work));
    sum.squared += i.squared, sum.work += i.work, sum.time += i.time;
  }
  const Impulse all = once.take_impulse(1);
  EXPECT_NEAR(all.squared, sum.squared, 1e-12 * sum.squared);
  EXPECT_NEAR(all.work, sum.work, 1e-12 * std::abs(sum.work));
  EXPECT_NEAR(all.time, sum.time, 1e-15);
  EXPECT_EQ(once.take_impulse(1).time, 0);
}

/// A stretched oval ring in still water: it gets going gently, and encloses the same water.
TEST(Simulation, StretchedClothStartsWithSmallSteps) {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {32, 32, 1};
  ClothCase ring;
  ring.arrangement = Arrangement::ring;
  ring.centre = {0.5, 0.5, 0};
  ring.radius = 0.25;
  ring.size = {1.6, 0};
  ring.ripple = 0.05;
  ring.ripples = 2;
  ring.material = {1000, 0, 1e-4, 0, 0, 0, 1e-3};
  whole.cloth = {ring};
  whole.time.end = 1;
  Simulation<2> simulation(whole, Parallel());
  const auto area = [&] {
    return enclosed_area(simulation.cloth().piece(simulation.cloth().groups[0], 0));
  };
  const double before = area();
  while (simulation.time() < 0.2) EXPECT_LT(simulation.step(0.2).courant, 0.5);
  EXPECT_NEAR(area(), before, 0.02 * before);
}

/// Each part of a step is told from the others.
TEST(Simulation, KnowsWhereItsTimeGoes) {
  Simulation<3> simulation(small_wash(), Parallel());
  run_to(simulation, 0.01);
  const auto& spent = simulation.clock().spent();
  for (const Phase phase : {Phase::solids, Phase::prediction, Phase::cloth, Phase::exchange,
                            Phase::projection, Phase::loads, Phase::rest})
    EXPECT_GT(spent[static_cast<std::size_t>(phase)], 0) << static_cast<int>(phase);
  EXPECT_EQ(spent[static_cast<std::size_t>(Phase::output)], 0);
}

TEST(Simulation, FixedStepIsTaken) {
  Simulation<3> simulation(small_wash({"time.step=2e-4 s", "time.fixed=true"}), Parallel());
  simulation.step(1);
  EXPECT_DOUBLE_EQ(simulation.time(), 2e-4);
}

/// Samples that cut the step short do not keep it from growing to what the CFL number allows: with
/// few steps to a sample each cut undoes a growth by a tenth.
TEST(Simulation, StepGrowsBetweenCloseSamples) {
  Case whole = read_case("cases/couette/case.toml", {"domain.cells=32", "time.fixed=false"});
  whole.time.step = 0;
  whole.time.cfl = 0.3;
  Simulation<2> simulation(whole, Parallel());
  constexpr double every = 0.02;
  for (int sample = 1; sample <= 100; ++sample)
    while (simulation.time() < sample * every - 1e-9) simulation.step(sample * every);
  simulation.step(101 * every);
  EXPECT_GT(simulation.last().courant, 0.15);
}

}  // namespace
}  // namespace washtub
