#include "washer/settle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "cloth/crossings.hpp"

using namespace washtub;
using ::testing::HasSubstr;

namespace {

std::string text(const std::string& cloth, const std::string& more) {
  return R"(
dimension = 2
[fluid]
viscosity = "0.1 Pa s"
[domain]
size = ["32 cm", "32 cm"]
cells = 32
[[cloth]]
size = ["10 cm"]
nodes = 7
count = 3
clearance = "1.2 cm"
excess_mass = "1 kg/m^2"
stretch_stiffness = "1e3 N/m"
bending_stiffness = "1e-4 N m"
thickness = "1 mm"
)" + cloth +
         "[time]\nend = \"1 s\"\nstep = \"2 ms\"\n" + more;
}

Case dropped(const std::string& more = "") {
  return read_case_text(text("arrangement = \"dropped\"\n", more), "dropped");
}

std::string error_of(const std::string& cloth, const std::string& more) {
  try {
    read_case_text(text(cloth, more), "dropped");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool go_on(const Simulation<2>&) { return true; }

}  // namespace

/// Threads sink to the floor and lie there, none through another.
TEST(Settle, DroppedClothLiesOnTheFloor) {
  const Case whole = dropped();
  EXPECT_EQ(whole.settle.time, 5);
  EXPECT_EQ(whole.settle.gravity, Vec<3>(0, -9.81, 0));
  const auto settled = settle<2>(whole, Parallel(), go_on);
  Simulation<2> simulation(whole, Parallel(), nullptr, settled.places);
  double lowest = 1, mean = 0;
  for (const auto& x : simulation.cloth().position) {
    lowest = std::min(lowest, x[1]);
    mean += x[1] / simulation.cloth().nodes();
  }
  EXPECT_NEAR(lowest, 0.005, 0.002);  // half a cell
  EXPECT_LT(mean, 0.05);
  EXPECT_FALSE(settled.stopped);
  EXPECT_LT(settled.speed, 0.02);
  const auto found = find_crossings(simulation.cloth(), simulation.grid().mesh());
  EXPECT_EQ(found.others + found.own, 0);
  EXPECT_EQ(simulation.time(), 0);
  EXPECT_EQ(simulation.last().kinetic, 0);
}

/// In the end a single piece rests, before the time is over.
TEST(Settle, EndsWhenTheClothRests) {
  Case whole = dropped();
  whole.cloth[0].count = 1;
  whole.settle.time = 60;
  const auto settled = settle<2>(whole, Parallel(), go_on);
  EXPECT_TRUE(settled.at_rest);
  EXPECT_LT(settled.time, 59);
}

/// Light cloth that springs flat first and then sinks slowly is not at rest until it lies.
TEST(Settle, IsNotAtRestWhileItSinks) {
  Case whole = dropped();
  whole.cloth[0].count = 1;
  whole.cloth[0].curvature = 12;
  whole.cloth[0].material.excess_mass = 0.05;
  whole.cloth[0].material.bending = 1e-2;
  whole.settle.time = 120;
  const auto settled = settle<2>(whole, Parallel(), go_on);
  const auto lowest = [](const std::vector<Vec<2>>& places) {
    double least = 1;
    for (const auto& x : places) least = std::min(least, x[1]);
    return least;
  };
  EXPECT_TRUE(settled.at_rest);
  EXPECT_GT(lowest(Simulation<2>(whole, Parallel()).cloth().position), 0.05);
  EXPECT_LT(lowest(settled.places), 0.02);
}

TEST(Settle, EndsWhenAskedTo) {
  int steps = 0;
  const auto settled = settle<2>(dropped(), Parallel(), [&](const Simulation<2>& simulation) {
    EXPECT_EQ(simulation.definition().fluid.gravity, Vec<3>(0, -9.81, 0));
    return ++steps < 3;
  });
  EXPECT_TRUE(settled.stopped);
  EXPECT_EQ(steps, 3);
}

/// Nothing but gravity moves anything.
TEST(Settle, LetsEverythingElseRest) {
  Case whole = dropped("[settle]\ntime = \"2 s\"\ngravity = [\"1 m/s^2\", \"0 m/s^2\"]\n");
  whole.domain.sides[3].velocity = Vec<3>(1, 0, 0);
  whole.fluid.velocity[0] = "1";
  whole.solids.push_back({.name = "fin",
                          .shape = sphere(Vec<3>(0.1, 0, 0), 0.01),
                          .centre = Vec<3>(0.16, 0.16, 0),
                          .drive = constant_speed(2)});
  whole.cloth[0].load = {"1", "0", "0"};
  const Case still = settling_case(whole);
  EXPECT_EQ(still.domain.sides[3].velocity, Vec<3>(0, 0, 0));
  EXPECT_EQ(still.fluid.velocity, FluidCase().velocity);
  EXPECT_FALSE(still.solids.back().drive.moving());
  EXPECT_EQ(still.cloth[0].load, ClothCase().load);
  EXPECT_EQ(still.fluid.gravity, Vec<3>(1, 0, 0));
  EXPECT_EQ(still.time.end, 2);
}

TEST(Settle, OtherStartsDoNotUnlessAskedTo) {
  const std::string random = "arrangement = \"random\"\n";
  EXPECT_EQ(read_case_text(text(random, ""), "it").settle.time, 0);
  EXPECT_EQ(read_case_text(text(random, "[settle]\ntime = \"2 s\"\n"), "it").settle.time, 2);
}

TEST(Settle, IsRefusedWhereNothingSinks) {
  EXPECT_THAT(error_of("arrangement = \"dropped\"\n", "[settle]\ntime = \"0 s\"\n"),
              HasSubstr("dropped cloth needs a time to settle in"));
  EXPECT_THAT(
      error_of("arrangement = \"random\"\n", "[settle]\ngravity = [\"0 m/s^2\", \"-1 m/s^2\"]\n"),
      HasSubstr("expected settle.time along with it"));
  std::string light = text("arrangement = \"dropped\"\n", "");
  light.replace(light.find("excess_mass = \"1 "), 17, "excess_mass = \"0 ");
  try {
    read_case_text(light, "it");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("cloth that weighs no more than water does not sink"));
  }
}
