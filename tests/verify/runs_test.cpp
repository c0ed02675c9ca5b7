#include "verify/runs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace washtub {
namespace {

using ::testing::ElementsAre;

/// A case with one `modes` run.
Expected plate() {
  Expected expected;
  expected.directory = "/cases/plate";
  RunSpec run;
  run.name = "coarse";
  run.command = "modes";
  expected.runs = {run};
  return expected;
}

TEST(RunWords, ModesRunsGiveAllThatQuantitiesAndFiguresAskFor) {
  Expected expected = plate();
  Quantity order;
  order.runs = {"coarse", "fine"};
  order.mode = 2;
  expected.quantities = {order};
  Curve curve;
  curve.runs = {"coarse"};
  curve.mode = 4;
  Figure figure;
  figure.curves = {curve};
  expected.figures = {figure};
  EXPECT_THAT(
      run_words(expected, expected.runs[0], "out"),
      ElementsAre("modes", "/cases/plate/case.toml", "--count", "4", "-o", "out/modes.json"));
}

TEST(RunWords, RunsTakeOneRankAndTheirSettings) {
  Expected expected = plate();
  expected.runs[0].command = "run";
  expected.runs[0].settings = {"domain.cells=64"};
  EXPECT_THAT(run_words(expected, expected.runs[0], "out"),
              ElementsAre("run", "/cases/plate/case.toml", "-o", "out", "-n", "1", "--no-report",
                          "--set", "domain.cells=64"));
}

TEST(RunWords, EnsemblesRunTheirMembersOneByOne) {
  Expected expected = plate();
  expected.runs[0].command = "run";
  expected.runs[0].seeds = "1-3";
  EXPECT_THAT(
      run_words(expected, expected.runs[0], "out"),
      ElementsAre("ensemble", "/cases/plate/case.toml", "-o", "out", "-j", "1", "--seeds", "1-3"));
}

}  // namespace
}  // namespace washtub
