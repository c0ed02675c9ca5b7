#include "report/run_record.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "report/facts.hpp"
#include "report/statistics.hpp"
#include "report/warnings.hpp"
#include "support/run_folder.hpp"

namespace washtub {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::RunFolder;
using ::testing::ThrowsMessage;

TEST(ReadRun, AWholeRunMissesNothing) {
  const RunFolder folder;
  const RunRecord run = folder.run("a/wash", {});
  EXPECT_THAT(run.missing, IsEmpty());
  EXPECT_EQ(run.name, "wash");
  EXPECT_EQ(run.definition->time.end, 4);
  EXPECT_EQ(run.history->rows(), 41U);
  EXPECT_EQ(outcome(run), "complete");
  EXPECT_EQ(dimension(run), 3);
  EXPECT_EQ(read_run(folder.path("a/wash/")).name, "wash");
  EXPECT_EQ(summary_number(run, {"run", "steps"}), 400);
  EXPECT_EQ(summary_number(run, {"run", "steps", "more"}), std::nullopt);
}

TEST(ReadRun, ADeepSummaryIsReadAsFarAsItIsOurs) {
  const RunFolder folder;
  folder.write("run/history.csv", RunFolder::history({}, 2));
  folder.write("run/summary.json", R"({"run": {"steps": 4, "x": )" + std::string(1000000, '[') +
                                       std::string(1000000, ']') + "}}");
  const RunRecord run = read_run(folder.path("run"));
  const RunRecord copy = run;
  EXPECT_EQ(summary_number(copy, {"run", "steps"}), 4);
}

TEST(ReadRun, RefusesWhatIsNoRun) {
  const RunFolder folder;
  const auto reading = [&](const std::string& name) {
    return [&folder, name] { read_run(folder.path(name)); };
  };
  EXPECT_THAT(reading("none"), ThrowsMessage<InputError>(HasSubstr("none: no such directory")));
  folder.write("file", "x");
  EXPECT_THAT(reading("file"), ThrowsMessage<InputError>(HasSubstr("file: is no directory")));
  std::filesystem::create_directory(folder.path("empty"));
  EXPECT_THAT(reading("empty"), ThrowsMessage<InputError>(HasSubstr("empty: is empty")));
  folder.write("case/case.toml", RunFolder::case_text());
  EXPECT_THAT(reading("case"), ThrowsMessage<InputError>(
                                   HasSubstr("case: has a case but no results; washtub run ")));
  folder.write("other/notes.txt", "x");
  EXPECT_THAT(reading("other"),
              ThrowsMessage<InputError>(HasSubstr(
                  "other: holds none of case.toml, history.csv and frames; name the directory")));
}

TEST(ReadRun, WhileTheRunGoesOn) {
  const RunFolder folder;
  folder.write("run/case.toml", RunFolder::case_text());
  folder.write("run/history.csv", RunFolder::history({}, 2) + "2.1,210,0.0");
  const RunRecord run = read_run(folder.path("run"));
  EXPECT_EQ(outcome(run), "unfinished");
  EXPECT_EQ(run.history->rows(), 21U);
  EXPECT_THAT(run.missing, Contains(HasSubstr("last line of history.csv is not complete")));
  EXPECT_THAT(run.missing, Contains(HasSubstr("no summary.json")));
}

TEST(ReadRun, DamageIsTold) {
  const RunFolder folder;
  folder.write("run/case.toml", "[washing]\nspeed = 3\n");
  folder.write("run/history.csv", "step,a\n1,2\n");
  folder.write("run/summary.json", "{\"run\": ");
  const RunRecord run = read_run(folder.path("run"));
  EXPECT_FALSE(run.definition || run.history);
  EXPECT_THAT(run.missing, Contains(HasSubstr("does not understand case.toml")));
  EXPECT_THAT(run.missing, Contains(HasSubstr("history.csv does not begin with the column")));
  EXPECT_EQ(run.history_text, "");
  EXPECT_THAT(run.missing, Contains(HasSubstr("summary.json is damaged")));
  EXPECT_EQ(quantities(run).size() + groups(run).size(), 0U);
  EXPECT_EQ(facts(run).size(), 1U);
  EXPECT_EQ(warnings(run).size(), 1U);
}

TEST(ReadRun, DamagedRowsAreLeftOut) {
  const RunFolder folder;
  folder.write("run/case.toml", RunFolder::case_text());
  folder.write("run/history.csv", "time [s],a\n0,1\n1,2,3\n2,x\n,4\n3,\n4");
  const RunRecord run = read_run(folder.path("run"));
  EXPECT_EQ(run.history->rows(), 2U);
  EXPECT_EQ(run.history_text, "time [s],a\n0,1\n3,\n");
  EXPECT_THAT(run.missing,
              Contains("history.csv: 3 rows are damaged and left out, the first in line 3."));
  EXPECT_THAT(run.missing, Contains(HasSubstr("last line of history.csv is not complete")));
}

TEST(ReadRun, EmptyFilesAreNotMissing) {
  const RunFolder folder;
  for (const char* name : {"run/case.toml", "run/history.csv", "run/summary.json"})
    folder.write(name, "");
  std::filesystem::create_directory(folder.path("run/tracks.csv"));
  const RunRecord run = read_run(folder.path("run"));
  for (const char* name : {"case.toml", "history.csv", "summary.json"})
    EXPECT_THAT(run.missing, Contains(std::string(name) + " is empty."));
  EXPECT_THAT(run.missing, Contains(HasSubstr("tracks.csv cannot be read: ")));
  EXPECT_THAT(run.missing, ::testing::Not(Contains(HasSubstr("There is no"))));
}

TEST(ReadRun, OtherColumnsAreTold) {
  const RunFolder folder;
  folder.write("run/case.toml", RunFolder::case_text());
  folder.write("run/history.csv", "time [s],sigma [Pa]\n0,1\n");
  EXPECT_THAT(read_run(folder.path("run")).missing,
              Contains("history.csv has no column \"stress\": it may be of another version."));
}

TEST(ReadRun, FramesAlone) {
  const RunFolder folder;
  folder.write("run/frames/0000.h5", "");
  const RunRecord run = read_run(folder.path("run"));
  EXPECT_THAT(run.missing, Contains(HasSubstr("There is no case.toml")));
  EXPECT_EQ(quantities(run).size(), 0U);
}

TEST(Facts, SayWhatTheCaseMeans) {
  const RunFolder folder;
  const RunRecord run = folder.run("a", {});
  const std::string text = facts(run).dump() + groups(run).dump();
  for (const char* part :
       {"16 x 16 x 16 cells", "z no-slip (lower) and slip (upper)", "1 piece of 0.1 x 0.1 m",
        "agitator: turns at up to 19.0986 rpm, period 1 s, 36.48 deg to and fro",
        "density omega_max r_o^2 / viscosity", "\"name\":\"To\""})
    EXPECT_THAT(text, HasSubstr(part));
}

}  // namespace
}  // namespace washtub
