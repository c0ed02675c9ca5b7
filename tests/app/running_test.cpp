#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <iterator>
#include <utility>

#include "program.hpp"

using testing::HasSubstr;
using testing::StartsWith;
using washtub::testing::Outcome;
using washtub::testing::Program;
namespace fs = std::filesystem;

namespace {

/// Runs that are disturbed, by signals or by each other.
class Running : public Program {
 protected:
  Running() {
    std::ofstream(folder / "box.toml")
        << "dimension = 2\n[fluid]\nviscosity = \"1 Pa s\"\n[domain]\nsize = [\"1 m\", \"1 m\"]\n"
           "cells = 16\n[domain.sides]\ny_upper = \"moving-wall\"\n"
           "y_upper_velocity = [\"1 m/s\", \"0 m/s\"]\n[time]\nend = \"1e5 s\"\nstep = \"1 ms\"\n"
           "[output]\nevery = \"0.1 s\"\n";
  }
  ~Running() override {
    if (child_ > 0) kill(child_, SIGKILL), waitpid(child_, nullptr, 0);
  }

  /// Starts a run that would not end by itself, and waits until it has written results.
  void begin(int ranks, const std::string& before = "", const std::string& until = "1e5 s") {
    child_ =
        start("run box.toml -o out -n " + std::to_string(ranks) + " --set time.end='" + until + "'",
              before);
    for (int wait = 0; wait < 600 && text("history.csv").size() < 1000; ++wait) usleep(50'000);
    ASSERT_GT(text("history.csv").size(), 1000U) << "no results after 30 s";
  }
  bool goes_on() const { return waitpid(child_, nullptr, WNOHANG) == 0; }
  /// Waits for its end. Returns the exit code.
  int end() {
    int status = 0;
    waitpid(std::exchange(child_, 0), &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  std::string text(const char* name) const {
    std::ifstream file(folder / "out" / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  /// A short run into the same directory.
  Outcome another() const {
    return run("run box.toml -o out --force --no-report -n 1 --set time.end='0.1 s'");
  }

  pid_t child_ = 0;
};

}  // namespace

TEST_F(Running, KeepsOtherRunsOutOfItsDirectory) {
  for (const int ranks : {1, 2}) {
    begin(ranks);
    const Outcome refused = another();
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.text, StartsWith("washtub: out: another run writes here: process " +
                                         std::to_string(child_) + " on "));
    const Outcome under_mpirun =
        run("run box.toml -o out --force", "", "mpirun --allow-run-as-root --oversubscribe -n 2 ");
    EXPECT_NE(under_mpirun.code, 0);
    EXPECT_THAT(under_mpirun.text, HasSubstr("washtub: out: another run writes here: process " +
                                             std::to_string(child_) + " on "));
    EXPECT_EQ(run("report out").code, 0);
    kill(child_, SIGTERM);
    EXPECT_EQ(end(), 130);
    EXPECT_FALSE(fs::exists(folder / "out" / "run.lock"));
    fs::remove_all(folder / "out");
  }
}

TEST_F(Running, LeavesNoLockWhenKilled) {
  for (const int ranks : {1, 2}) {
    begin(ranks);
    kill(child_, SIGKILL);
    end();
    Outcome next = another();
    for (int wait = 0; wait < 100 && next.code == 2; ++wait) {  // mpirun is still ending the ranks
      usleep(100'000);
      next = another();
    }
    EXPECT_EQ(next.code, 0) << next.text;
    fs::remove_all(folder / "out");
  }
}

TEST_F(Running, EndsInOrderWhenItsTerminalIsClosed) {
  for (const int ranks : {1, 2}) {
    begin(ranks);
    kill(child_, SIGHUP);
    kill(child_, SIGHUP);
    EXPECT_EQ(end(), 130);
    EXPECT_THAT(text("summary.json"), HasSubstr("\"outcome\": \"stopped\""));
    EXPECT_THAT(text("log.txt"), HasSubstr("stopped: t "));
    EXPECT_TRUE(fs::exists(folder / "out" / "report.html"));
    fs::remove_all(folder / "out");
  }
}

TEST_F(Running, GoesOnWithoutItsTerminalUnderNohup) {
  begin(1, "trap '' HUP && ");
  kill(child_, SIGHUP);
  usleep(500'000);
  EXPECT_TRUE(goes_on());
  kill(child_, SIGTERM);
  EXPECT_EQ(end(), 130);
}

TEST_F(Running, SaysThatItsReportCannotBeWritten) {
  for (const int ranks : {1, 2}) {
    begin(ranks, "", ranks == 1 ? "50 s" : "20 s");
    fs::create_directories(folder / "out" / "report.html");
    EXPECT_EQ(end(), 3);
    std::ifstream console(folder / "console.txt");
    EXPECT_THAT(std::string(std::istreambuf_iterator<char>(console), {}),
                HasSubstr("no report: cannot write out/report.html: Is a directory; the results "
                          "are there, make it with: washtub report out"));
    EXPECT_THAT(text("log.txt"), HasSubstr("no report: cannot write"));
    EXPECT_THAT(text("summary.json"), HasSubstr("\"outcome\": \"complete\""));
    fs::remove_all(folder / "out");
  }
}

TEST_F(Running, TellsExitCodes) {
  EXPECT_THAT(run("--help").text, HasSubstr("3    run: complete, but its report.html"));
  EXPECT_EQ(run("reference > /dev/full").code, 1) << "what was printed is lost";
}
