#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "program.hpp"

using testing::HasSubstr;
using washtub::testing::Outcome;
using washtub::testing::Program;
namespace fs = std::filesystem;

namespace {

/// Two samples of a small plane wash.
std::string short_run(const std::string& more = "", int ranks = 1) {
  return "run " + fs::absolute("cases/wash-2d/case.toml").string() + " -n " +
         std::to_string(ranks) +
         " -o out --set domain.cells=32 --set time.end='0.02 s' --set output.every='0.01 s'"
         " --set output.frames='0.01 s' --set output.window='[\"0 s\", \"0.02 s\"]' " +
         more;
}

std::string text(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

class Report : public Program {};

TEST_F(Report, NeedsARun) {
  refuses("report nowhere", "nowhere: no such directory; washtub run -o nowhere CASE makes one");
  fs::create_directories(folder / "empty");
  EXPECT_EQ(run("report empty").text, "washtub: empty: is empty; it has no results of a run\n");
  std::ofstream(folder / "empty" / "notes.txt") << "x";
  const Outcome outcome = run("report empty");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, HasSubstr("holds none of case.toml, history.csv and frames"));
}

TEST_F(Report, RefusesWrongSizes) {
  for (const std::string size : {"wide", "20 XB", "-3 MB", "0", "nan"})
    refuses("report out --max-size '" + size + "'",
            "--max-size \"" + size +
                "\": expected a size such as \"20 MB\" or \"500 kB\", or a number of MB");
}

TEST_F(Report, EndsARun) {
  const Outcome outcome = run(short_run());
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("out/report.html: "));
  EXPECT_THAT(text(folder / "out" / "log.txt"), HasSubstr("out/report.html: "));
  EXPECT_THAT(text(folder / "out" / "log.txt"), HasSubstr("] commit "));
  for (const char* fact : {"commit", "compiler", "vector width [bit]", "processor"})
    EXPECT_THAT(text(folder / "out" / "summary.json"), HasSubstr('"' + std::string(fact) + "\":"));
  EXPECT_THAT(text(folder / "out" / "report.html"), HasSubstr("id=\"washtub-data\""));
  const Outcome again = run(short_run("--force --no-report"));
  EXPECT_EQ(again.code, 0) << again.text;
  EXPECT_FALSE(fs::exists(folder / "out" / "report.html")) << "that of the earlier run";
  EXPECT_EQ(run("report out -o page.html --max-size '1.5 MB'").code, 0);
  EXPECT_LE(fs::file_size(folder / "page.html"), 1500000U);
  EXPECT_THAT(run("report out --max-size 1kB").text, HasSubstr("the smallest possible page has"));
}

TEST_F(Report, RefusesToReplaceOtherFiles) {
  EXPECT_EQ(run(short_run()).code, 0);
  std::ofstream(folder / "notes.html") << "kept";
  const Outcome outcome = run("report out -o notes.html");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text,
            "washtub: notes.html: exists and is no page of washtub; name another file with -o\n");
  EXPECT_EQ(fs::file_size(folder / "notes.html"), 4U);
  EXPECT_EQ(run("report out").code, 0);  // in place of that of the run
}

TEST_F(Report, IsMadeOnceForSeveralRanks) {
  for (const std::string more : {"", "--force --set coupling.strain_limit=1e-9"}) {
    const Outcome outcome = run(short_run(more, 2));
    const std::string log = text(folder / "out" / "log.txt");
    const auto at = log.find("out/report.html: ");
    ASSERT_NE(at, std::string::npos) << log << outcome.text;
    EXPECT_EQ(log.find("out/report.html: ", at + 1), std::string::npos) << log;
    EXPECT_EQ(log[log.rfind('\n', at) + 1], '[') << "the log's format";
  }
}

TEST_F(Report, ForceClearsAllThatWasMadeOfARun) {
  for (const char* name : {"movie.mp4", "movie.mp4.part", "report.html.part", "mine.txt"}) {
    fs::create_directories(folder / "out");
    std::ofstream(folder / "out" / name) << "x";
  }
  EXPECT_EQ(run(short_run("--force --no-report")).code, 0);
  EXPECT_FALSE(fs::exists(folder / "out" / "movie.mp4"));
  EXPECT_FALSE(fs::exists(folder / "out" / "movie.mp4.part"));
  EXPECT_FALSE(fs::exists(folder / "out" / "report.html.part"));
  EXPECT_TRUE(fs::exists(folder / "out" / "mine.txt"));
}

TEST_F(Report, FollowsAFailedRun) {
  const Outcome outcome = run(short_run("--set coupling.strain_limit=1e-9"));
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_THAT(text(folder / "out" / "report.html"), HasSubstr("id=\"washtub-data\""));
}

TEST_F(Report, DoesNotSpoilARun) {
  fs::create_directories(folder / "out" / "report.html.part" / "in-the-way");
  const Outcome outcome = run(short_run("--force"));
  EXPECT_EQ(outcome.code, 3) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("no report: cannot write out/report.html"));
  EXPECT_THAT(text(folder / "out" / "log.txt"), HasSubstr("no report: "));
}
