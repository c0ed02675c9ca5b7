#include "report/warnings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/run_folder.hpp"

namespace washtub {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::RunFolder;

std::vector<std::string> sentences(const RunRecord& run) { return warnings(run); }

TEST(Warnings, NothingToWarnOf) {
  const RunFolder folder;
  EXPECT_TRUE(sentences(folder.run("a", {})).empty());
}

TEST(Warnings, NameValueAndThreshold) {
  const RunFolder folder;
  folder.run("a", {});
  folder.write("a/summary.json", R"({"run": {"outcome": "cloth 7 stretched 34 %", "steps": 400,
      "largest courant number": 0.42, "largest divergence h/U": 2e-4,
      "unconverged pressure solves": 3},
      "coupling": {"largest strain": 0.14, "mean rms slip / largest speed": 0.011,
      "largest rms slip / largest speed": 0.096, "deepest penetration of a solid [m]": 0.02,
      "deepest a node would have gone into a solid [m]": 0.3},
      "warnings": ["The grid does not resolve this flow."]})");
  EXPECT_THAT(
      sentences(read_run(folder.path("a"))),
      ElementsAre(
          "An error ended the run: cloth 7 stretched 34 %.", "The grid does not resolve this flow.",
          HasSubstr("up to 9.6 % of the largest speed, 1.1 % on average; below 5 %"),
          HasSubstr("strained by 14 %; its stress is linear in strain, which holds below "
                    "10 %"),
          HasSubstr("node of the cloth was 0.02 m inside a solid, "),
          HasSubstr("would have gone 0.3 m into a solid in one step, "),
          "The pressure did not converge in 3 of 400 steps.",
          HasSubstr("divergence of the water reaches 0.0002 U/h, the solver's target 0.0001"),
          HasSubstr("Courant number is 0.42, above the limit of 0.3")));
}

TEST(Warnings, AHairInsideASolidIsNone) {
  const RunFolder folder;
  folder.run("a", {});
  folder.write("a/summary.json", R"({"run": {"outcome": "complete"},
      "coupling": {"deepest penetration of a solid [m]": 1e-4}})");
  EXPECT_TRUE(sentences(read_run(folder.path("a"))).empty());
}

TEST(Warnings, SpeedsThatJump) {
  const RunFolder folder;
  folder.run("a", {});
  std::string text = RunFolder::case_text();
  const auto stroke = text.find("stroke = "), end = text.find('\n', stroke);
  text.replace(stroke, end - stroke,
               "stroke = { kind = \"table\", times = [\"0 s\", \"1 s\"], speeds = [\"0 rpm\", "
               "\"20 rpm\"] }");
  folder.write("a/case.toml", text);
  EXPECT_THAT(sentences(read_run(folder.path("a"))),
              ElementsAre(HasSubstr("its speed jumps from 20 to 0 rpm every 1 s")));
}

TEST(Warnings, ShortRuns) {
  const RunFolder folder;
  folder.write("a/case.toml", RunFolder::case_text());
  const auto after = [&](double end) {
    folder.write("a/history.csv", RunFolder::history({}, end));
    return sentences(read_run(folder.path("a")));
  };
  EXPECT_THAT(after(0.5), Contains(HasSubstr("reached 0.5 s, the window of the statistics begins "
                                             "at 1 s")));
  EXPECT_THAT(after(2.5), Contains(HasSubstr("goes on to 4 s")));
  EXPECT_THAT(after(2.5), Contains(HasSubstr("holds one whole cycle of the drive")));
  EXPECT_THAT(after(3.5), Contains(HasSubstr("holds two whole cycles only")));
  EXPECT_THAT(after(0.5), Contains(HasSubstr("The run has no end yet")));
}

TEST(Warnings, WindowFromTheStart) {
  const RunFolder folder;
  std::string text = RunFolder::case_text();
  text.replace(text.find("[\"1 s\""), 6, "[\"0 s\"");
  EXPECT_THAT(sentences(folder.run("a", {}, text)),
              ElementsAre(HasSubstr("begins at 0 s, in the first cycle after the start")));
}

/// Without a summary the samples tell: a slip of 0.2 m/s in water of 1 m/s.
TEST(Warnings, FromTheHistoryOfARunThatGoesOn) {
  const RunFolder folder;
  folder.write("a/case.toml", RunFolder::case_text());
  folder.write("a/history.csv",
               "time [s],time step [s],courant,divergence,speed [m/s],largest strain,slip [m/s]\n"
               "0,0,0,0,0,0,0\n4,0.001,0.29,1e-5,1,0.2,0.2\n");
  const auto found = sentences(read_run(folder.path("a")));
  EXPECT_THAT(found, Contains(HasSubstr("slips through the water at up to 20 %")));
  EXPECT_THAT(found, Contains(HasSubstr("strained by 20 %")));
  EXPECT_THAT(found, Contains(HasSubstr("kept the step below 0.01 s (time.step) in 50 %")));
}

}  // namespace
}  // namespace washtub
