#include <gmock/gmock.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/small_wash.hpp"

using testing::HasSubstr;
using testing::Not;
using washtub::testing::Outcome;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Ensembles : public washtub::testing::Program {
 protected:
  Ensembles() {
    std::ofstream(folder / "small.toml") << washtub::testing::small_wash("0.1", "0.3");
  }
  json pooled(const std::string& directory) const {
    std::ifstream file(folder / directory / "pooled.json");
    return json::parse(file);
  }
};

}  // namespace

TEST_F(Ensembles, RunsMembersKeepsThemAndPoolsThem) {
  const Outcome first = run("ensemble small.toml --seeds 2 -o all");
  ASSERT_EQ(first.code, 0) << first.text;
  EXPECT_THAT(first.text, HasSubstr("seeds 1, 2\n"));
  EXPECT_TRUE(fs::exists(folder / "all" / "ensemble.html"));
  ASSERT_EQ(pooled("all")["stress"]["members [Pa]"].size(), 2U);

  // More members: those that are there are kept.
  const Outcome more = run("ensemble small.toml --seeds 3 -o all");
  ASSERT_EQ(more.code, 0) << more.text;
  EXPECT_THAT(more.text, HasSubstr("seed-2: kept"));
  EXPECT_THAT(more.text, HasSubstr("seed-3: done"));
  const json three = pooled("all");
  ASSERT_EQ(three["stress"]["members [Pa]"].size(), 3U);
  EXPECT_NE(three["stress"]["members [Pa]"][0], three["stress"]["members [Pa]"][1]);

  // The member with seed 1 is the case as it is.
  ASSERT_EQ(run("run small.toml -n 1 --no-report -o single").code, 0);
  std::ifstream file(folder / "single" / "summary.json");
  const double mean = json::parse(file)["cloth"]["stress"]["mean [Pa]"];
  EXPECT_NEAR(three["stress"]["members [Pa]"][0], mean, 1e-6 * mean);

  // Longer: they go on.
  const Outcome longer =
      run("ensemble small.toml --seeds 2 -o all --set 'time.end=0.4 s' --set "
          "'output.window=[\"0.1 s\", \"0.4 s\"]'");
  EXPECT_EQ(longer.code, 0) << longer.text;
  EXPECT_THAT(longer.text, HasSubstr("seed-1: done"));

  // What is lost is made again.
  fs::remove(folder / "all" / "seed-2" / "history.csv");
  const Outcome mended =
      run("ensemble small.toml --seeds 2 -o all --set 'time.end=0.4 s' --set "
          "'output.window=[\"0.1 s\", \"0.4 s\"]'");
  EXPECT_EQ(mended.code, 0) << mended.text;
  EXPECT_THAT(mended.text, HasSubstr("seed-1: kept"));
  EXPECT_THAT(mended.text, HasSubstr("seed-2: done"));

  // Too small a page: the numbers are there.
  const Outcome small =
      run("ensemble small.toml --seeds 2 -o all --max-size '1 kB' --set 'time.end=0.4 s' --set "
          "'output.window=[\"0.1 s\", \"0.4 s\"]'");
  EXPECT_EQ(small.code, 3);
  EXPECT_THAT(small.text, HasSubstr("does not fit"));

  // Back to a shorter time, or another case: nothing is touched.
  const Outcome shorter = run("ensemble small.toml --seeds 2 -o all");
  EXPECT_EQ(shorter.code, 2);
  EXPECT_THAT(shorter.text, HasSubstr("beyond time.end"));
  const Outcome other = run("ensemble small.toml --seeds 2 -o all --set 'fluid.viscosity=2 Pa s'");
  EXPECT_EQ(other.code, 2);
  EXPECT_THAT(other.text, HasSubstr("is of another case: fluid.viscosity = \"1 Pa s\", here \"2 "
                                    "Pa s\"; name another directory with -o, or"));
  EXPECT_EQ(pooled("all")["stress"]["members [Pa]"].size(), 2U);

  // Held against a run, and an ensemble.
  const Outcome against = run("compare all single");
  EXPECT_EQ(against.code, 0) << against.text;
  EXPECT_THAT(against.text, HasSubstr("Ensembles are held against single runs here"));
}

TEST_F(Ensembles, SaysWhichMemberFailed) {
  const Outcome outcome =
      run("ensemble small.toml --seeds 2 -o all --set coupling.strain_limit=1e-6");
  EXPECT_EQ(outcome.code, 1) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("seed-1: failed after"));
  EXPECT_THAT(outcome.text, HasSubstr("strain_limit"));
  EXPECT_THAT(outcome.text, Not(HasSubstr("quantity")));
}

TEST_F(Ensembles, Refusals) {
  const auto refused = [&](const std::string& arguments, const std::string& what) {
    const Outcome outcome = run("ensemble small.toml " + arguments);
    EXPECT_EQ(outcome.code, 2) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr(what));
  };
  refused("--seeds 1", "--seeds 1: should be how many");
  refused("--set 'cloth.count=0'", "nothing in this case is drawn at random");
  fs::create_directories(folder / "mine");
  std::ofstream(folder / "mine" / "thesis.txt") << "dear";
  refused("-o mine", "mine: holds files that are of no ensemble");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder / "mine"), fs::directory_iterator()), 1);
}
