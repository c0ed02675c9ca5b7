#include "batch/batch.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "io/scratch.hpp"

namespace washtub {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

/// Runs of the shell, each in a folder of its own.
class Batch : public ::testing::Test {
 protected:
  BatchRun run(const std::string& name, const std::string& script, double cost = 0) {
    results_.push_back(std::make_unique<RunResult>());
    results_.back()->directory = path(name);
    BatchRun run;
    run.name = name;
    run.words = {"-c", "cd " + path(name) + " && " + script};
    run.again = {"-c", "cd " + path(name) + " && echo again >> said"};
    run.fingerprint = {{"script", script}};
    run.cost = cost;
    run.result = results_.back().get();
    return run;
  }
  void make(const std::vector<BatchRun>& runs, bool force = false, int at_once = 1) {
    said_.clear();
    make_batch(runs, {"/bin/sh", at_once, force, [] { return false; },
                      [this](const std::string& line) { said_.push_back(line); }});
  }
  std::string path(const std::string& name) const { return folder_ / name; }
  std::string text(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  Scratch folder_;
  std::vector<std::unique_ptr<RunResult>> results_;
  std::vector<std::string> said_;
};

TEST_F(Batch, MakesTheLongestFirstAndKeepsWhatIsFinished) {
  const std::vector<BatchRun> runs = {run("short", "echo one >> said", 1),
                                      run("long", "echo one >> said", 9)};
  make(runs);
  EXPECT_THAT(said_, ElementsAre("long: started, 1 of 2", HasSubstr("long: done"),
                                 "short: started, 2 of 2", HasSubstr("short: done")));
  make(runs);
  EXPECT_THAT(said_, ElementsAre(HasSubstr("short: kept"), HasSubstr("long: kept")));
  EXPECT_TRUE(runs[0].result->finished());
  EXPECT_EQ(text("long/said"), "one\n");
  make(runs, true);
  EXPECT_EQ(text("long/said"), "one\none\n");
  make({run("long", "echo other >> said")});
  EXPECT_EQ(text("long/said"), "one\none\nother\n");
}

TEST_F(Batch, AFailureSaysWhyAndStopsNoOther) {
  const std::vector<BatchRun> runs = {run("bad", "echo 'washtub: too hot'; echo more; exit 4"),
                                      run("good", "true")};
  make(runs);
  EXPECT_EQ(runs[0].result->state, RunState::failed);
  EXPECT_EQ(runs[0].result->error, "too hot");
  EXPECT_EQ(runs[1].result->state, RunState::done);
  make(runs);
  EXPECT_THAT(said_, Contains("bad: started, 1 of 1"));
}

/// Only where the command had begun, and would be the same.
TEST_F(Batch, GoesOnWithWhatWasInterrupted) {
  BatchRun cut = run("cut", "echo begun >> said; touch log; exit 1");
  make({cut});
  make({cut});
  EXPECT_EQ(text("cut/said"), "begun\nbegun\n");  // it cannot go on
  cut.trace = "log";
  make({cut}, true);
  EXPECT_EQ(text("cut/said"), "begun\nbegun\nbegun\n");
  make({cut});
  EXPECT_EQ(cut.result->state, RunState::done);
  EXPECT_EQ(text("cut/said"), "begun\nbegun\nbegun\nagain\n");
  BatchRun other = run("cut", "echo other >> said");
  other.trace = "log";
  make({other});
  EXPECT_THAT(text("cut/said"), Not(HasSubstr("again\nagain")));
}

TEST_F(Batch, WhatIsNotWantedIsOnlyLookedFor) {
  BatchRun idle = run("idle", "true");
  idle.wanted = false;
  make({idle});
  EXPECT_EQ(idle.result->state, RunState::not_run);
  EXPECT_FALSE(std::filesystem::exists(path("idle")));
}

}  // namespace
}  // namespace washtub
