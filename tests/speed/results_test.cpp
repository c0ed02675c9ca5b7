#include "speed/results.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "io/file.hpp"
#include "io/scratch.hpp"
#include "speed/suite.hpp"

using namespace washtub;
using ::testing::HasSubstr;

namespace {

Speeds some() {
  return {"abc",
          "a processor",
          2,
          {{"triad", 0.01, 0, 1e8}, {"step", 0.02, 1e6, 0}, {"prediction", 0.004, 1e6, 1e7}}};
}

}  // namespace

TEST(Speeds, ReadBackWhatWasWritten) {
  const Scratch folder;
  replace_file(folder / "a.json", to_json(some()).dump());
  const Speeds read = read_speeds(folder / "a.json");
  EXPECT_EQ(to_json(read), to_json(some()));
  EXPECT_EQ(read.ranks, 2);
}

TEST(Speeds, AreNotReadFromAnythingElse) {
  const Scratch folder;
  const auto refusal = [&](const std::string& text) {
    replace_file(folder / "b.json", text);
    try {
      read_speeds(folder / "b.json");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  for (const char* text : {"", "{}", "[1]", R"({"kind": "washtub bench"})",
                           R"({"kind": "other", "commit": "", "processor": "", "ranks": 1,
                               "results": []})",
                           R"({"kind": "washtub bench", "commit": "", "processor": "", "ranks": 1,
                               "results": [{"name": "a", "time [s]": 0, "cells": 1, "bytes": 1}]})"})
    EXPECT_THAT(refusal(text), HasSubstr("no results of washtub bench")) << text;
  EXPECT_THROW(read_speeds(folder / "none.json"), InputError);
}

TEST(Speeds, TableTellsRatesAndRatios) {
  Speeds before = some();
  before.results[1].seconds = 0.05;
  before.results.erase(before.results.begin() + 2);
  EXPECT_EQ(speed_table(some(), &before),
            "                   ms   Mcells/s     GB/s   of triad   speed-up\n"
            "triad              10          -       10      100 %          1\n"
            "step               20         50        -          -        2.5\n"
            "prediction          4        250      2.5       25 %          -\n");
  EXPECT_THAT(speed_table(some()), ::testing::Not(HasSubstr("speed-up")));
}

TEST(Speeds, AreMeasuredOfWhatMatches) {
  const auto results = measure_speeds(Parallel(), std::regex("solids|interpolate"));
  ASSERT_EQ(results.size(), 2u);
  EXPECT_EQ(results[0].name, "solids, 64^3");
  EXPECT_EQ(results[0].cells, 64 * 64 * 64);
  for (const Speed& s : results) EXPECT_GT(s.seconds, 0);
}
