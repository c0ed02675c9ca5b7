#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "program.hpp"
#include "support/small_wash.hpp"

using testing::HasSubstr;
using washtub::testing::Outcome;

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Compare : public washtub::testing::Program {
 protected:
  void make_run(const std::string& name, const std::string& more = "") const {
    std::ofstream(folder / "small.toml") << washtub::testing::small_wash("0.1", "0.4");
    const Outcome outcome = run("run small.toml -n 1 --no-report -o " + name + " " + more);
    ASSERT_EQ(outcome.code, 0) << outcome.text;
  }
  json summary(const std::string& name) const {
    std::ifstream file(folder / name / "summary.json");
    return json::parse(file);
  }
  /// What the page holds.
  json page(const std::string& name) const {
    std::ifstream file(folder / name);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    const std::string mark = "id=\"washtub-data\">";
    const auto begin = text.rfind(mark) + mark.size();
    return json::parse(text.substr(begin, text.find("</script>", begin) - begin));
  }
};

json quantity(const json& page, const std::string& name, std::size_t run) {
  for (const json& row : page["comparison"]["rows"])
    if (row["name"] == name) return row["values"][run];
  return {};
}

void expect_near(const json& a, const json& b) {
  ASSERT_TRUE(a.is_number() && b.is_number()) << a << " " << b;
  EXPECT_NEAR(a.get<double>(), b.get<double>(), 1e-6 * std::abs(b.get<double>()));
}

TEST_F(Compare, WhatThePageSaysAgreesWithTheSummaries) {
  make_run("a");
  make_run("b", "--set cloth.seed=2");
  const Outcome outcome = run("compare a b");
  EXPECT_EQ(outcome.code, 0) << outcome.text;
  EXPECT_THAT(outcome.text, HasSubstr("cloth.seed: 1 in a, 2 in b."));
  EXPECT_THAT(outcome.text, HasSubstr("agitator energy per cycle [J/m]"));
  const json all = page("comparison.html");
  ASSERT_EQ(all["runs"].size(), 2U);
  for (std::size_t run = 0; run < 2; ++run) {
    const json one = summary(run == 0 ? "a" : "b");
    const json &cloth = one["cloth"], &agitator = one["solids"][1];
    expect_near(quantity(all, "stress", run)["mean"], cloth["stress"]["mean [Pa]"]);
    expect_near(quantity(all, "stress", run)["scaled"]["half_width"],
                cloth["stress, 95 % half width / sigma_o"]);
    expect_near(quantity(all, "bending stress", run)["mean"], cloth["bending stress"]["mean [Pa]"]);
    expect_near(quantity(all, "tub rms torque", run)["scaled"]["mean"],
                one["solids"][0]["rms torque / tau_o"]);
    const json energy = quantity(all, "agitator energy per cycle", run);
    expect_near(energy["mean"], agitator["mean energy per cycle [J/m]"]);
    expect_near(energy["half_width"], agitator["energy per cycle, 95 % half width [J/m]"]);
    expect_near(quantity(all, "agitator mean power", run)["mean"], agitator["mean power [W/m]"]);
    EXPECT_EQ(quantity(all, "scatter about the common centre", run)["batches"], 3);
    for (const std::string about : {"the common centre", "each piece's own centre"}) {
      const std::string name = "scatter about " + about;
      expect_near(quantity(all, name, run)["mean"], cloth[name + " [m]"]);
      const std::vector<double> cycles = cloth[name + " in each cycle [m]"];
      EXPECT_GE(cloth[name + " [m]"], *std::min_element(cycles.begin(), cycles.end()));
      EXPECT_LE(cloth[name + " [m]"], *std::max_element(cycles.begin(), cycles.end()));
    }
  }
}

TEST_F(Compare, RefusesWhatCannotBeCompared) {
  refuses("compare", "a comparison needs two directories or more, as in washtub compare A B");
  refuses("compare a b", "a: no such directory; washtub run -o a CASE makes one");
  EXPECT_THAT(run("compare a b --max-size lots").text,
              HasSubstr("--max-size \"lots\": expected a size"));
  make_run("a", "--set 'time.end=4 ms' --set 'output.window=[\"0 s\", \"4 ms\"]'");
  EXPECT_EQ(run("compare a").code, 2);
  EXPECT_THAT(run("compare a ./a/").text,
              HasSubstr("a and ./a/ are the same directory; name each run once"));
  EXPECT_THAT(run("compare a .").text, HasSubstr(".: holds none of case.toml, history.csv and"));
}

TEST_F(Compare, RefusesToReplaceOtherFiles) {
  const std::string brief = "--set 'time.end=4 ms' --set 'output.window=[\"0 s\", \"4 ms\"]'";
  make_run("a", brief);
  make_run("b", brief);
  std::ofstream(folder / "notes.html") << "kept";
  const Outcome outcome = run("compare a b -o notes.html");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text,
            "washtub: notes.html: exists and is no page of washtub; name another file with -o\n");
  EXPECT_EQ(fs::file_size(folder / "notes.html"), 4U);
  EXPECT_EQ(run("compare a b").code, 0);
  EXPECT_EQ(run("compare a b").code, 0);  // in place of the page before
  const std::string small = run("compare a b --max-size 1kB").text;
  EXPECT_THAT(small, testing::StartsWith("washtub: comparison.html: does not fit"));
}

}  // namespace
