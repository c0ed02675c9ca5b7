#include "report/comparison.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "base/error.hpp"
#include "measure/cycles.hpp"
#include "report/settings.hpp"
#include "support/run_folder.hpp"

namespace washtub {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::RunFolder;
using ::testing::ThrowsMessage;

/// Stress of `level` plus -scatter, 0, +scatter in the three cycles.
RunFolder::Signals steps(double level, double scatter) {
  return {.stress = [=](double t) { return level + scatter * (std::ceil(t - 1e-6) - 3); }};
}

const CompareRow& named(const RunComparison& comparison, const std::string& name) {
  for (const CompareRow& row : comparison.rows)
    if (row.name == name) return row;
  throw std::out_of_range(name);
}

TEST(Compare, WelchOnTheCycles) {
  const RunFolder folder;
  const std::vector<Compared> runs = {Compared(folder.run("A", steps(100, 2))),
                                      Compared(folder.run("B", steps(112, 1))),
                                      Compared(folder.run("C", steps(101, 5)))};
  const RunComparison comparison = compare(runs);
  const CompareRow& stress = named(comparison, "stress");
  const std::vector<double> a = {98, 100, 102}, b = {111, 112, 113};
  EXPECT_FALSE(stress.against[0]);
  EXPECT_NEAR(stress.against[1]->percent, 12, 1e-9);
  EXPECT_NEAR(*stress.against[1]->half_width, welch(a, b).half_width, 1e-9);
  EXPECT_EQ(stress.against[1]->significant(), true);
  EXPECT_EQ(stress.against[2]->significant(), false);
  const double width = welch(a, b).half_width;
  EXPECT_THAT(
      comparison.sentences,
      Contains(fmt::format("stress: 12.0 % higher in B than in A (95 % interval {:.1f} % to "
                           "{:.1f} %).",
                           12 - width, 12 + width)));
  EXPECT_THAT(comparison.sentences, Contains(HasSubstr("stress: no significant difference, ")));
  EXPECT_THAT(comparison.sentences, Contains(HasSubstr("one in twenty")));
  const auto json = to_json(comparison);
  EXPECT_EQ(json["rows"][0]["name"], "stress");
  EXPECT_TRUE(json["rows"][0]["against_first"][0].is_null());
  EXPECT_EQ(json["rows"][0]["against_first"][1]["significant"], true);
}

TEST(Compare, LowerReadsAsHowMuchLower) {
  const RunFolder folder;
  const auto comparison = compare(
      {Compared(folder.run("A", steps(100, 0.1))), Compared(folder.run("B", steps(80, 0.1)))});
  EXPECT_THAT(comparison.sentences,
              Contains("stress: 20.00 % lower in B than in A (95 % interval 19.77 % to 20.23 %)."));
}

TEST(Compare, RoundingIsNoDifference) {
  const RunFolder folder;
  const auto comparison = compare(
      {Compared(folder.run("A", steps(100, 0))), Compared(folder.run("B", steps(100.00005, 0)))});
  const auto& against = named(comparison, "stress").against[1];
  EXPECT_EQ(against->difference, 0);
  EXPECT_EQ(against->significant(), false);
  EXPECT_THAT(comparison.sentences, Contains("stress: the same in B and A."));
}

TEST(Compare, AgainstNothingInTheUnit) {
  const RunFolder folder;
  const auto comparison =
      compare({Compared(folder.run("A", steps(0, 1))), Compared(folder.run("B", steps(20, 1))),
               Compared(folder.run("C", {}))});
  const auto& against = named(comparison, "stress").against[1];
  EXPECT_NEAR(against->difference, 20, 1e-9);
  EXPECT_EQ(against->percent, 0);
  EXPECT_EQ(against->significant(), true);
  EXPECT_THAT(
      comparison.sentences,
      Contains("stress: 20.0 Pa higher in B than in A (95 % interval 17.7 Pa to 22.3 Pa)."));
  EXPECT_THAT(comparison.sentences, Contains("stress: the same in C and A."));
}

TEST(AsExact, DigitsFollowTheWidth) {
  EXPECT_EQ(as_exact(12.3456, 0.21), "12.35");
  EXPECT_EQ(as_exact(12.3456, 3.4), "12.3");
  EXPECT_EQ(as_exact(1234.56, 78), "1235");
  EXPECT_EQ(as_exact(167703, 25000), "168000");
  EXPECT_EQ(as_exact(1.23456e7, 2.5e5), "1.235e+07");
  EXPECT_EQ(as_exact(0.000123456, 2e-6), "1.235e-04");
  EXPECT_EQ(as_exact(12.3456, {}), "12.35");
}

TEST(Compare, OneCycleCannotTell) {
  const RunFolder folder;
  const RunRecord a = folder.run("A", steps(100, 1));
  folder.run("B", steps(150, 1));
  folder.write("B/history.csv", RunFolder::history(steps(150, 1), 2.5));
  const auto comparison = compare({Compared(a), Compared(read_run(folder.path("B")))});
  EXPECT_FALSE(named(comparison, "stress").against[1]->significant());
  EXPECT_THAT(comparison.sentences,
              Contains(HasSubstr("cannot be told, B has it for fewer than two whole cycles")));
  EXPECT_TRUE(to_json(comparison)["rows"][0]["against_first"][1]["significant"].is_null());
}

TEST(Compare, RunsThatDidNotReachTheirEnd) {
  const RunFolder folder;
  const RunRecord a = folder.run("A", {});
  folder.run("B", {});
  folder.write("B/summary.json", R"({"run": {"outcome": "stopped"}})");
  EXPECT_THAT(compare({Compared(a), Compared(read_run(folder.path("B")))}).sentences,
              Contains("B did not reach its end: stopped."));
}

TEST(Compare, WhatOnlyOneRunHas) {
  const RunFolder folder;
  const RunRecord a = folder.run("A", steps(100, 1));
  std::string text = RunFolder::case_text();
  const auto begin = text.find("[[cloth]]");
  text.erase(begin, text.find("[time]") - begin);
  const auto comparison = compare({Compared(a), Compared(folder.run("B", {}, text))});
  EXPECT_FALSE(named(comparison, "stress").values[1]);
  EXPECT_THAT(comparison.sentences, Contains("stress: not known for B."));
  EXPECT_THAT(comparison.sentences, Contains("agitator rms torque: the same in B and A."));
}

TEST(Settings, KeysThatDiffer) {
  const RunFolder folder;
  std::string other = RunFolder::case_text();
  other.replace(other.find("1 Pa s"), 6, "2 Pa s");
  other.replace(other.find("made up"), 7, "another");
  other.replace(other.find("[[cloth]]"), 9, "[[cloth]]\ncount = 3");
  const std::vector<RunRecord> runs = {folder.run("A", {}), folder.run("B", {}, other),
                                       folder.run("C", {})};
  EXPECT_THAT(differing_settings({&runs[0], &runs[1], &runs[2]}),
              ElementsAre("fluid.viscosity: \"1 Pa s\" in A and C, \"2 Pa s\" in B.",
                          "cloth.count: not set in A and C, 3 in B."));
  EXPECT_THAT(differing_settings({&runs[0], &runs[2]}),
              ElementsAre("The runs have the same settings."));
}

TEST(PrepareComparison, Refusals) {
  const RunFolder folder;
  std::vector<Compared> one = {Compared(folder.run("A", {}))};
  EXPECT_THAT([&] { prepare_comparison(one); },
              ThrowsMessage<InputError>(HasSubstr("needs two directories or more")));
  std::vector<Compared> twice = {one[0], Compared(read_run(folder.path("A/.")))};
  EXPECT_THAT([&] { prepare_comparison(twice); },
              ThrowsMessage<InputError>(HasSubstr("are the same directory")));
  std::vector<Compared> mixed = {one[0], one[0]};
  folder.run("flat", {});
  mixed[1] = Compared(read_run(folder.path("flat")));
  mixed[1].run.definition->dimension = 2;
  EXPECT_THAT([&] { prepare_comparison(mixed); },
              ThrowsMessage<InputError>(HasSubstr("A is 3-D and ")));
}

TEST(PrepareComparison, UnknownDimensionsAreNoReason) {
  const RunFolder folder;
  std::vector<Compared> runs = {Compared(folder.run("A", {})), Compared(folder.run("B", {}))};
  runs[0].run.definition->dimension = 2;
  runs[1].run.definition.reset();
  runs[1].run.history.reset();
  EXPECT_NO_THROW(prepare_comparison(runs));
}

TEST(PrepareComparison, NamesAreTold) {
  const RunFolder folder;
  std::vector<Compared> runs = {Compared(folder.run("slow/wash", {})),
                                Compared(folder.run("fast/wash", {}))};
  prepare_comparison(runs);
  EXPECT_EQ(runs[0].name, "slow/wash");
  EXPECT_EQ(runs[1].name, "fast/wash");
}

}  // namespace
}  // namespace washtub
