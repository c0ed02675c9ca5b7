#include "verify/judge.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "io/history.hpp"
#include "verify/folder.hpp"
#include "verify/series.hpp"

namespace washtub {
namespace {

using testing::Folder;
using ::testing::HasSubstr;

Quantity valued(double value, double tolerance) {
  Quantity q;
  q.value = value;
  q.tolerance = tolerance;
  return q;
}

TEST(Judge, ToleranceIsOfTheValueOnBothSides) {
  EXPECT_EQ(judge(valued(2, 0.1), 2.09).verdict, Verdict::pass);
  EXPECT_EQ(judge(valued(2, 0.1), 1.89).verdict, Verdict::miss);
  EXPECT_NEAR(judge(valued(2, 0.1), 1.89).deviation, -0.11, 1e-12);
  Quantity q;
  q.value = -200;
  q.tolerance_percent = 5;
  EXPECT_EQ(judge(q, -209).verdict, Verdict::pass);
  EXPECT_EQ(judge(q, -211).verdict, Verdict::miss);
}
TEST(Judge, Bounds) {
  Quantity least, most;
  least.at_least = 1.8;
  most.at_most = 0.01;
  EXPECT_EQ(judge(least, 1.9).verdict, Verdict::pass);
  EXPECT_EQ(judge(least, 1.7).verdict, Verdict::miss);
  EXPECT_EQ(judge(most, 0.009).verdict, Verdict::pass);
  EXPECT_EQ(judge(most, 0.011).verdict, Verdict::miss);
}
TEST(Judge, NoNumberIsAMiss) {
  EXPECT_EQ(judge(valued(2, 1e9), std::nan("")).verdict, Verdict::miss);
}
TEST(Judge, AKnownMissIsNoWorseThanKnown) {
  Quantity q = valued(2, 0.1);
  q.known_miss = 2.5;
  EXPECT_EQ(judge(q, 2.54).verdict, Verdict::known_miss);
  EXPECT_EQ(judge(q, 2.3).verdict, Verdict::known_miss);
  EXPECT_EQ(judge(q, 1.7).verdict, Verdict::miss);
  EXPECT_EQ(judge(q, 2.56).verdict, Verdict::miss);
  EXPECT_EQ(judge(q, 2.05).verdict, Verdict::pass);
  EXPECT_EQ(judge(valued(2, 0.1), 2.5).verdict, Verdict::miss);
}
TEST(Judge, InformativeNeverDecides) {
  Quantity q = valued(2, 0.1);
  q.decides = false;
  EXPECT_EQ(judge(q, 2).verdict, Verdict::informative);
  EXPECT_EQ(judge(q, 5).verdict, Verdict::informative);
}

TEST(Order, OfTwoErrorsAndOfThreeValues) {
  EXPECT_NEAR(observed_order({5 + 0.09, 5 - 0.01}, 3, 5), 2, 1e-12);
  const auto value = [](double h) { return 7 + 0.4 * h * h; };
  EXPECT_NEAR(observed_order({value(0.4), value(0.2), value(0.1)}, 2, 0), 2, 1e-12);
  EXPECT_TRUE(std::isnan(observed_order({1, 2, 1.5}, 2, 0)));
  EXPECT_TRUE(std::isnan(observed_order({1, 0}, 2, 0)));
}

TEST(HistoryColumns, ByNameWithAndWithoutUnitBetweenTimes) {
  const Folder folder;
  {
    History history(folder.path("history.csv"), {{"time", "s"}, {"speed", "m/s"}, {"slip", "m/s"}});
    for (int i = 0; i <= 10; ++i)
      history.add(std::vector<double>{0.1 * i, 2.0 * i, i % 2 ? 1.0 * i : std::nan("")});
  }
  const CsvTable file = read_table(folder.path("history.csv"));
  const auto all = series(file, "speed", {0, 100});
  EXPECT_EQ(all.values.size(), 11U);
  EXPECT_EQ(series(file, "speed [m/s]", {0.3, 0.5}).values, (std::vector<double>{6, 8, 10}));
  EXPECT_EQ(series(file, "slip", {0, 0.5}).values, (std::vector<double>{1, 3, 5}));
  EXPECT_EQ(difference(all, all).values[3], 0);
  EXPECT_THROW(difference(all, series(file, "slip", {0, 100})), InputError);
  try {
    series(file, "sped", {0, 100});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("history.csv: no column \"sped\", nearest: \"speed\""));
  }
}

TEST(Measured, NumberOfTheSummaryByPointer) {
  const Folder folder;
  folder.write("summary.json", R"({"run": {"steps": 12}, "solids": [{"name": "a", "force": 3}]})");
  folder.write("modes.json", R"({"frequencies [Hz]": [1.5, 4]})");
  RunResult run;
  run.directory = folder.path("");
  Measured what;
  what.summary = "/solids/0/force";
  what.per = 2;
  EXPECT_EQ(measured_number(what, run), 1.5);
  what.summary = "/run/step";
  try {
    measured_number(what, run);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no number at \"/run/step\", nearest: \"/run/steps\""));
  }
  Measured mode;
  mode.mode = 2;
  EXPECT_EQ(measured_number(mode, run), 4);
  mode.mode = 3;
  EXPECT_THROW(measured_number(mode, run), InputError);
}

}  // namespace
}  // namespace washtub
