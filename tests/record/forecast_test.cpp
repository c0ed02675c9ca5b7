#include "record/forecast.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "io/frame_reader.hpp"
#include "io/scratch.hpp"
#include "record/output.hpp"

namespace washtub {
namespace {

Case small_wash(const std::vector<std::string>& more = {}) {
  std::vector<std::string> settings = {"domain.cells=16", "cloth.count=4", "cloth.nodes=[5, 5]",
                                       "output.window="};
  settings.insert(settings.end(), more.begin(), more.end());
  return read_case("cases/wash-3d/case.toml", settings);
}

long steps_to(Simulation<3>& simulation, double end, double every) {
  const long before = simulation.last().number;
  for (double row = every; row < end + 1e-9; row += every)
    while (simulation.time() < row - 1e-9) simulation.step(row);
  return simulation.last().number - before;
}

TEST(Forecast, FixedStepsAreCounted) {
  Case whole;
  whole.time = {.end = 1, .step = 3e-3, .fixed = true};
  EXPECT_EQ(foresee_steps(whole, 1, 1), 334);
}

/// Rows cut steps short, and a faster drive takes more of them where the CFL number binds.
TEST(Forecast, StepsFollowRowsAndDrive) {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {100, 100, 1};
  whole.time = {.end = 1, .step = 0.04};
  whole.output.every = 0.1;
  EXPECT_EQ(foresee_steps(whole, 0, 0), 30);    // 2.5 steps to a row
  EXPECT_EQ(foresee_steps(whole, 0, 30), 100);  // of 10 ms at CFL 0.3
  whole.solids = {{"stirrer", sphere(Vec<3>::Zero(), 0.1), {0.5, 0.5, 0}, constant_speed(10)}};
  const double slow = foresee_steps(whole, 1, 0);
  EXPECT_NEAR(foresee_steps(whole, 2, 0), 2 * slow, 0.02 * slow);
}

/// Of a run whose steps the drive limits, within a few per cent.
TEST(Forecast, StepsAreThoseOfTheRun) {
  const Case whole = small_wash({"time.end=0.2 s"});
  Simulation<3> simulation(whole, Parallel());
  const double driving = simulation.driving_speed();
  const auto taken = static_cast<double>(steps_to(simulation, 0.2, whole.output.every));
  EXPECT_NEAR(foresee_steps(whole, driving, 0), taken, 0.05 * taken);
}

/// Sizes on the disk are those that the run will have.
TEST(Forecast, SizesAreThoseOfTheFiles) {
  const Case whole = small_wash({"time.end=0.1 s", "output.frames=10 ms"});
  const Forecast forecast = foresee(whole, Parallel());
  EXPECT_TRUE(forecast.failure.empty()) << forecast.failure;
  EXPECT_EQ(forecast.coarser, 1);
  EXPECT_GT(forecast.seconds, 0);
  Simulation<3> simulation(whole, Parallel());
  Observer<3> observer(simulation);
  const Scratch folder;
  Output<3> output(simulation, observer, folder.path());
  output.start();
  output.add_row(observer.observe());
  output.add_frame();
  const auto frame = static_cast<double>(std::filesystem::file_size(frame_path(folder.path(), 0)));
  EXPECT_NEAR(forecast.frames, 11 * frame, 0.2 * 11 * frame);
  // The state of a grid is some doubles a cell at least.
  EXPECT_GT(forecast.checkpoints, 16 * 16 * 16 * 8 * 5);
  EXPECT_GT(forecast.memory, forecast.checkpoints);
}

}  // namespace
}  // namespace washtub
