#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "io/file.hpp"
#include "io/history.hpp"
#include "io/summary.hpp"
#include "scratch.hpp"

namespace washtub {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<Column> columns = {{"time", "s"}, {"outer torque", "N m"}, {"steps", ""}};

TEST(ReplaceFile, TakesThePlaceOfTheOldFile) {
  const Scratch dir;
  replace_file(dir / "a.txt", "one");
  replace_file(dir / "a.txt", "two");
  EXPECT_EQ(contents(dir / "a.txt"), "two");
  EXPECT_EQ(dir.entries(), 1);
}

TEST(ReplaceFile, MissingDirectoryIsNamed) {
  const Scratch dir;
  EXPECT_THAT([&] { replace_file(dir / "none/a.txt", "x"); },
              ThrowsMessage<RunError>("cannot write " + (dir / "none/a.txt") +
                                      ": No such file or directory"));
}

TEST(ReplaceFile, FailureLeavesNothingBehind) {
  const Scratch dir;
  std::filesystem::create_directories(dir / "taken/inside");
  EXPECT_THAT([&] { replace_file(dir / "taken", "x"); },
              ThrowsMessage<RunError>(HasSubstr("cannot write " + (dir / "taken"))));
  EXPECT_EQ(dir.entries(), 1);
}

TEST(History, HeaderCarriesUnitsAndRowsAreOnDiskAtOnce) {
  const Scratch dir;
  History history(dir / "history.csv", columns);
  history.add(std::vector<double>{0.5, -1.25e-7, 12});
  EXPECT_EQ(contents(dir / "history.csv"), "time [s],outer torque [N m],steps\n0.5,-1.25e-07,12\n");
  history.add(std::vector<double>{1, std::nan(""), 13});
  EXPECT_THAT(contents(dir / "history.csv"), HasSubstr("\n1,,13\n"));
  history.add(std::vector<double>{0.1 + 0.2, std::numeric_limits<double>::infinity(), 1.0 / 3});
  EXPECT_THAT(contents(dir / "history.csv"), HasSubstr("\n0.30000000000000004,,0.333333333\n"));
}

TEST(History, FullDiskIsReported) {
  EXPECT_THAT([] { History("/dev/full", columns); },
              ThrowsMessage<RunError>("cannot write /dev/full: No space left on device"));
}

TEST(History, MissingDirectoryIsReported) {
  EXPECT_THAT([] { History("/nowhere/history.csv", columns); },
              ThrowsMessage<RunError>(HasSubstr("/nowhere/history.csv: No such file")));
}

TEST(History, RemovedOrReplacedInMidRunIsReported) {
  const Scratch dir;
  const std::string path = dir / "history.csv";
  History history(path, columns);
  history.add(std::vector<double>{0.5, 1, 2});
  std::filesystem::rename(path, dir / "away.csv");
  const auto next = [&] { history.add(std::vector<double>{0.6, 1, 2}); };
  EXPECT_THAT(next, ThrowsMessage<RunError>(
                        HasSubstr(path + ": it was removed or replaced while the run went on")));
  replace_file(path, "the text of an editor\n");
  EXPECT_THAT(next, ThrowsMessage<RunError>(HasSubstr("removed or replaced")));
}

TEST(History, RowsMustFitTheColumns) {
  const Scratch dir;
  History history(dir / "history.csv", columns);
  EXPECT_THAT(
      [&] {
        history.add(std::vector<double>{1, 2});
      },
      ThrowsMessage<RunError>(HasSubstr("2 values for 3 columns")));
}

TEST(History, ResumedItDropsWhatTheCheckpointDidNotSee) {
  const Scratch dir;
  const std::string path = dir / "history.csv";
  {
    History history(path, columns);
    for (const double t : {0.1, 0.2, 0.3}) history.add(std::vector<double>{t, 1, 2});
  }
  std::ofstream(path, std::ios::app) << "0.1,half a ro";
  History(path, columns, 2).add(std::vector<double>{0.25, 7, 8});
  EXPECT_EQ(contents(path), "time [s],outer torque [N m],steps\n0.1,1,2\n0.2,1,2\n0.25,7,8\n");
}

TEST(History, ResumeRefusesAnotherRunsFile) {
  const Scratch dir;
  History(dir / "h.csv", {{"time", "s"}});
  EXPECT_THAT([&] { History(dir / "h.csv", columns, 1); },
              ThrowsMessage<RunError>(AllOf(HasSubstr("\"time [s]\""), HasSubstr("another run"))));
}

TEST(Summary, KeepsTheOrderOfKeysAndWritesNullForUnknown) {
  const Scratch dir;
  nlohmann::ordered_json summary;
  summary["zeta"] = 0.1;
  summary["alpha"]["mean [Pa]"] = std::numeric_limits<double>::quiet_NaN();
  write_summary(dir / "summary.json", summary);
  EXPECT_EQ(contents(dir / "summary.json"),
            "{\n  \"zeta\": 0.1,\n  \"alpha\": {\n    \"mean [Pa]\": null\n  }\n}\n");
}

}  // namespace
}  // namespace washtub
