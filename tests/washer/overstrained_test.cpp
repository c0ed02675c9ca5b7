#include "washer/overstrained.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "washer/simulation.hpp"

namespace washtub {
namespace {

using ::testing::MatchesRegex;

Case plane() {
  Case whole;
  whole.dimension = 2;
  whole.domain.cells = {32, 48, 1};
  return whole;
}

TEST(Overstrained, SaysWhereHowMuchAndWhatHelps) {
  EXPECT_EQ(overstrained({(1.5625 - 1) / 2, 6, {0, 3}}, plane()),
            "piece 7 of the cloth is stretched by 25 % at node 3, limit 18.3 % "
            "(coupling.strain_limit = 0.2); try more domain.cells than 32 x 48 or a larger "
            "cloth.stretch_stiffness; a smaller time.step seldom helps");
}

TEST(Overstrained, TellsShortenedFromStretched) {
  Case whole = plane();
  whole.dimension = 3;
  whole.domain.cells = {16, 16, 8};
  whole.coupling.strain_limit = 0.095;
  whole.coupling.scheme = Scheme::broyden;
  EXPECT_EQ(overstrained({(0.64 - 1) / 2, 0, {2, 4}}, whole),
            "piece 1 of the cloth is shortened by 20 % at node (2, 4), limit 10 % "
            "(coupling.strain_limit = 0.095); try a larger coupling.strain_limit, or a smaller "
            "time.step, coupling.scheme = "
            "\"implicit\", more domain.cells than 16 x 16 x 8 or a larger cloth.stretch_stiffness");
}

/// A ring that starts stretched by 5 % along its arcs, by 4.8 % along its chords.
TEST(Overstrained, EndsARun) {
  Case whole = plane();
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {32, 32, 1};
  ClothCase ring;
  ring.arrangement = Arrangement::ring;
  ring.centre = {0.5, 0.5, 0};
  ring.radius = 0.25;
  ring.size = {1.496, 0};
  ring.material = {1000, 0, 1e-4, 0, 0, 0, 1e-3};
  whole.cloth = {ring};
  whole.coupling.strain_limit = 0.02;
  whole.time.end = 1;
  whole.time.step = 1e-4;
  Simulation<2> simulation(whole, Parallel());
  try {
    simulation.step(1);
    FAIL() << "goes on";
  } catch (const RunError& error) {
    EXPECT_THAT(error.what(), MatchesRegex("step 1, t = [0-9.]+ s: piece 1 of the cloth is "
                                           "stretched by [2-4]\\.[0-9]+ % at node [0-9]+, limit "
                                           "1\\.98 % .*"));
  }
}

}  // namespace
}  // namespace washtub
