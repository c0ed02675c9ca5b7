#include "verify/figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/history.hpp"
#include "verify/folder.hpp"

namespace washtub {
namespace {

using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;

/// A case whose run `one` is finished and whose run `two` is not.
struct Sample {
  Sample() {
    folder.write("deck/one/summary.json", R"({"run": {"steps": 8}})");
    {
      History history(folder.path("deck/one/history.csv"), {{"time", "s"}, {"speed", "m/s"}});
      for (int i = 0; i < 5; ++i) history.add(std::vector<double>{1.0 * i, -4.0 * i});
    }
    c.expected.name = "deck";
    for (const char* name : {"one", "two"}) {
      RunSpec run;
      run.name = name;
      c.expected.runs.push_back(run);
    }
    c.runs.resize(2);
    c.runs[0].directory = folder.path("deck/one");
    c.runs[0].state = RunState::done;
  }
  Figure& add(FigureKind kind) {
    Figure figure;
    figure.name = "a-figure";
    figure.kind = kind;
    c.expected.figures.push_back(figure);
    return c.expected.figures.back();
  }

  Folder folder;
  CaseRuns c;
};

Curve over_time(const std::string& run) {
  Curve curve;
  curve.label = run;
  curve.run = run;
  curve.column = "speed";
  curve.per = 2;
  return curve;
}

TEST(Figures, DrawFinishedRunsOverTime) {
  Sample s;
  Figure& figure = s.add(FigureKind::history);
  figure.curves = {over_time("two")};
  EXPECT_EQ(figure_script(s.c, figure), "");
  figure.curves.push_back(over_time("one"));
  const std::string script = figure_script(s.c, figure);
  EXPECT_THAT(script, HasSubstr("3 -6\n"));
  EXPECT_THAT(script, Not(HasSubstr("$c1")));
}

TEST(Figures, ConvergenceHasSizesBesideTheReference) {
  Sample s;
  Figure& figure = s.add(FigureKind::convergence);
  Curve ours, paper;
  ours.label = "ours \"x\"";
  ours.runs = {"one", "two"};
  ours.x = {0.2, 0.1};
  ours.column = "speed";
  paper.label = "paper";
  paper.x = {0.2, 0.1};
  paper.values = {3, 1};
  figure.curves = {ours, paper};
  figure.slopes = {2};
  const std::string script = figure_script(s.c, figure);
  EXPECT_THAT(script, HasSubstr("0.2 16\nEND"));
  EXPECT_THAT(script, HasSubstr("0.1 1\nEND"));
  EXPECT_THAT(script, HasSubstr("title \"ours \\\"x\\\"\""));
  EXPECT_THAT(script, HasSubstr("slope 2"));
}

TEST(Figures, AreSvgThatFollowsThePage) {
  Sample s;
  s.add(FigureKind::history).curves = {over_time("one")};
  const auto drawn = draw_figures(s.c, s.folder.path(""));
  if (drawn[0].note.find("not installed") != std::string::npos) GTEST_SKIP() << drawn[0].note;
  EXPECT_EQ(drawn[0].note, "");
  EXPECT_TRUE(drawn[0].svg.starts_with("<svg"));
  EXPECT_THAT(drawn[0].svg, Not(HasSubstr("\"black\"")));
  EXPECT_THAT(s.folder.read("deck/a-figure.svg"), HasSubstr("prefers-color-scheme"));
}

TEST(Figures, SayWhichColumnIsMissing) {
  Sample s;
  Curve curve = over_time("one");
  curve.column = "sped";
  s.add(FigureKind::history).curves = {curve};
  EXPECT_THAT(draw_figures(s.c, s.folder.path(""))[0].note, HasSubstr("nearest: \"speed\""));
}

}  // namespace
}  // namespace washtub
