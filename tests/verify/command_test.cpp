#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "support/small_wash.hpp"
#include "verify/folder.hpp"

namespace washtub {
namespace {

using testing::Folder;
using ::testing::HasSubstr;
using ::testing::Not;

/// A disc that turns in a ring of water: 20 steps on 32 x 32 cells.
constexpr const char* tiny_case = R"(dimension = 2
[fluid]
viscosity = "10 Pa s"
[domain]
lower = ["-1 m", "-1 m"]
size = ["2 m", "2 m"]
cells = 32
[[solid]]
name = "disc"
shape = { kind = "sphere", radius = "0.5 m" }
drive = { kind = "constant", speed = "1 rad/s" }
[time]
end = "0.2 s"
step = "10 ms"
fixed = true
[output]
every = "20 ms"
)";

constexpr const char* tiny_expected = R"(title = "Tiny"
[[run]]
name = "one"
[[run]]
name = "big"
level = "full"
set = ["domain.cells=64"]
[[quantity]]
name = "speed"
run = "one"
column = "disc speed"
take = "mean"
window = ["0.02 s", "1 s"]
value = 1.0
tolerance = 1e-6
unit = "rad/s"
source = "the drive"
[[quantity]]
name = "rough guess"
run = "one"
summary = "/run/steps"
value = 100
decides = false
source = "recalled"
[[figure]]
name = "speed"
caption = "Speed of the disc."
[[figure.curve]]
label = "one"
run = "one"
column = "disc speed"
)";

struct Outcome {
  int code;
  std::string text;  ///< of both output streams
};

class Verify : public ::testing::Test {
 protected:
  Verify() {
    folder.write("cases/tiny/case.toml", tiny_case);
    expect(tiny_expected);
  }
  void expect(const std::string& text) { folder.write("cases/tiny/expected.toml", text); }
  /// The case with a text of expected.toml replaced.
  void expect(const std::string& from, const std::string& to) {
    std::string text = tiny_expected;
    expect(text.replace(text.find(from), from.size(), to));
  }
  /// `before`: a command that runs the program, such as timeout.
  Outcome run(const std::string& arguments, const std::string& before = "") const {
    const std::string command =
        "cd " + folder.path("") + " && env -u OMPI_COMM_WORLD_SIZE -u PMIX_RANK -u PMI_RANK " +
        before + " " + WASHTUB_PROGRAM + " verify --cases cases " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    Outcome outcome;
    std::array<char, 4096> part{};
    while (const size_t count = fread(part.data(), 1, part.size(), pipe))
      outcome.text.append(part.data(), count);
    const int status = pclose(pipe);
    outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return outcome;
  }
  nlohmann::json report() const {
    return nlohmann::json::parse(folder.read("out/verification/verification.json"));
  }

  Folder folder;
};

TEST_F(Verify, WritesTablePageAndNumbers) {
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("1 pass, 0 miss, 0 known misses, 1 informative"));
  const auto json = report();
  EXPECT_EQ(json["cases"][0]["runs"][0]["state"], "done");
  EXPECT_EQ(json["cases"][0]["runs"][1]["state"], "not run");
  EXPECT_NEAR(json["cases"][0]["quantities"][0]["measured"], 1, 1e-9);
  EXPECT_EQ(json["cases"][0]["quantities"][1]["verdict"], "informative");
  EXPECT_THAT(folder.read("out/verification/verification.html"), HasSubstr("Speed of the disc."));
}

TEST_F(Verify, KeepsFinishedRunsOfTheSameCase) {
  run("");
  EXPECT_THAT(run("").text, HasSubstr("tiny/one: kept"));
  EXPECT_THAT(run("--force").text, HasSubstr("tiny/one: started"));
  folder.write("cases/tiny/case.toml", std::string(tiny_case) + "# changed\n");
  EXPECT_THAT(run("").text, HasSubstr("tiny/one: started"));
  expect("name = \"one\"", "name = \"one\"\nset = [\"domain.cells=16\"]");
  EXPECT_THAT(run("").text, HasSubstr("tiny/one: started"));
}

TEST_F(Verify, AMissEndsWithOne) {
  expect("value = 1.0", "value = 1.1");
  const Outcome outcome = run("tiny");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.text, HasSubstr("MISS"));
  EXPECT_EQ(report()["cases"][0]["quantities"][0]["verdict"], "miss");
}

TEST_F(Verify, AFailedRunShowsItsErrorAndIsAMiss) {
  expect("name = \"one\"", "name = \"one\"\nset = [\"fluid.viscosity=1\"]");
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_THAT(outcome.text, HasSubstr("run one failed: --set fluid.viscosity = 1: expected"));
}

TEST_F(Verify, TakesAKnownMissOnlyWhereAsked) {
  expect("value = 1.0", "value = 2.0\nknown_miss = 1.0");
  const Outcome strict = run("");
  EXPECT_EQ(strict.code, 1);
  EXPECT_THAT(strict.text, HasSubstr("MISS, known"));
  EXPECT_EQ(run("--allow-known").code, 0);
}

TEST_F(Verify, WrongColumnsAreWrongInputButTheReportIsWritten) {
  expect("disc speed", "disc sped");
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_THAT(outcome.text, HasSubstr("no column \"disc sped\", nearest: \"disc speed\""));
  EXPECT_EQ(report()["miss"], 1);
}

TEST_F(Verify, RefusesWrongKeysAndUnknownCasesBeforeAnythingRuns) {
  Outcome outcome = run("tine");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text, "washtub: no verification case tine, nearest: tiny\n");
  expect("tolerance =", "tolerence =");
  outcome = run("");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text,
            "washtub: cases/tiny/expected.toml:15: quantity[1].tolerence = 1e-06: unknown key, "
            "nearest known: quantity.tolerance\n");
  EXPECT_FALSE(std::filesystem::exists(folder.path("out")));
}

/// Runs a command, and asks it to stop once its endless run has written something.
constexpr const char* until_it_runs =
    "sh -c '\"$@\" & until [ -s out/verification/tiny/big/history.csv ]; do sleep 0.05; done; "
    "kill -TERM $!; wait $!' sh";

TEST_F(Verify, InterruptedItKeepsWhatIsFinished) {
  expect("set = [\"domain.cells=64\"]", "set = [\"time.end=2000 s\"]");
  run("");
  const Outcome outcome = run("--level full", until_it_runs);
  EXPECT_EQ(outcome.code, 130) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("tiny/big: stopped"));
  const auto json = report();
  EXPECT_TRUE(json["interrupted"]);
  EXPECT_EQ(json["cases"][0]["runs"][0]["state"], "kept");
  EXPECT_EQ(json["pass"], 1);
}

constexpr const char* drawn_expected = R"(title = "Drawn"
[[run]]
name = "both"
seeds = "2"
[[quantity]]
name = "seeds"
run = "both"
summary = "/seeds/1"
value = 2
tolerance = 0
source = "the run"
[[quantity]]
name = "half width of the stress"
run = "both"
summary = "/stress/95 % half width ~1 sigma_o"
at_least = 1e-9
source = "starts differ"
)";

TEST_F(Verify, ARunMayBeAnEnsemble) {
  std::filesystem::remove_all(folder.path("cases/tiny"));
  folder.write("cases/drawn/case.toml", testing::small_wash("0", "0.2"));
  folder.write("cases/drawn/expected.toml", drawn_expected);
  const Outcome outcome = run("");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("2 pass, 0 miss"));
  EXPECT_THAT(run("").text, HasSubstr("drawn/both: kept"));
  std::string text = drawn_expected;
  folder.write("cases/drawn/expected.toml",
               text.replace(text.find("summary"), 20, "column = \"stress\"\ntake = \"mean\""));
  EXPECT_THAT(run("").text, HasSubstr("is an ensemble, of which only `summary` can be asked"));
}

TEST_F(Verify, ListsWithoutRunning) {
  const Outcome outcome = run("--list");
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.text, "tiny: Tiny\n  one, quick\n  big, full\n");
}

}  // namespace
}  // namespace washtub
