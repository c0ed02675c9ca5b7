#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "measure/cycles.hpp"
#include "report/statistics.hpp"
#include "support/run_folder.hpp"

namespace washtub {
namespace {

using testing::RunFolder;

RunQuantity named(const RunRecord& run, const std::string& name) {
  for (const RunQuantity& quantity : find_quantities(run))
    if (quantity.name == name) return quantity;
  throw std::out_of_range(name);
}

/// 1, 2, 3 in the three cycles of the window.
double cycle_of(double t) { return std::ceil(t - 1e-6) - 1; }

TEST(Quantities, OneBatchPerCycle) {
  const RunFolder folder;
  const RunRecord run =
      folder.run("a", {.stress = [](double t) { return t < 1.05 ? 100 : 10 * cycle_of(t); }});
  const RunQuantity stress = named(run, "stress");
  ASSERT_EQ(stress.batches.size(), 3U);
  EXPECT_NEAR(stress.batches[0], 10, 1e-9);
  EXPECT_NEAR(stress.batches[2], 30, 1e-9);
  EXPECT_NEAR(stress.mean, 20, 1e-9);
  EXPECT_NEAR(*stress.half_width(), student_95(2) * 10 / std::sqrt(3.0), 1e-9);
  const auto json = to_json(stress);
  EXPECT_EQ(json["unit"], "Pa");
  EXPECT_NEAR(json["scaled"]["mean"].get<double>(), 20 / 1000.0, 1e-12);  // rho r^2 omega^2
  EXPECT_EQ(json["scaled"]["by"], "sigma_o");
}

TEST(Quantities, TorquesByTheirRmsAndEnergyPerCycle) {
  const RunFolder folder;
  const RunRecord run =
      folder.run("a", {.torque = [](double t) { return std::sin(2 * M_PI * t) * cycle_of(t); },
                       .power = [](double t) { return 7 * cycle_of(t); }});
  EXPECT_NEAR(named(run, "tub rms torque").batches[1], 2 * std::sqrt(0.5), 1e-5);
  EXPECT_NEAR(named(run, "tub rms torque").mean, std::sqrt((1 + 4 + 9) / 3.0 / 2), 1e-5);
  EXPECT_NEAR(named(run, "agitator mean power").mean, 14, 1e-9);
  EXPECT_NEAR(named(run, "agitator energy per cycle").batches[2], 21, 1e-9);
  EXPECT_NEAR(named(run, "agitator rms torque").mean, 5, 1e-9);
}

TEST(Quantities, OneCycleTellsNoInterval) {
  const RunFolder folder;
  folder.write("a/case.toml", RunFolder::case_text());
  folder.write("a/history.csv", RunFolder::history({.stress = [](double t) { return t; }}, 2.5));
  const RunQuantity stress = named(read_run(folder.path("a")), "stress");
  EXPECT_EQ(stress.batches.size(), 1U);
  EXPECT_NEAR(stress.mean, 1.55, 1e-9);  // of the values at 1.1, 1.2, ..., 2, as the batch
  EXPECT_TRUE(to_json(stress)["half_width"].is_null());
}

/// Walls that turn on and on, as in cases/couette.
TEST(Quantities, WithoutAPeriodThereIsNoEnergyPerCycle) {
  const RunFolder folder;
  std::string text = RunFolder::case_text();
  const std::string stroke = "{ kind = \"sinusoid\", peak = \"2 rad/s\", frequency = \"1 Hz\" }";
  text.replace(text.find(stroke), stroke.size(), "{ kind = \"constant\", speed = \"2 rad/s\" }");
  const RunRecord run = folder.run("a", {.power = [](double) { return 7; }}, text);
  EXPECT_THROW(named(run, "agitator energy per cycle"), std::out_of_range);
  EXPECT_NEAR(named(run, "agitator mean power").mean, 7, 1e-9);
  EXPECT_EQ(named(run, "agitator mean power").batches.size(), 8U);
}

TEST(Quantities, MeansRestOnTheWholeCycles) {
  const RunFolder folder;
  folder.write("a/case.toml", RunFolder::case_text());
  folder.write("a/history.csv",
               RunFolder::history({.stress = [](double t) { return t < 3.05 ? t : 100; },
                                   .torque = [](double t) { return t < 3.05 ? t : 100; }},
                                  3.8));
  for (const RunQuantity& quantity : find_quantities(read_run(folder.path("a")))) {
    const auto [low, high] = std::minmax_element(quantity.batches.begin(), quantity.batches.end());
    ASSERT_EQ(quantity.batches.size(), 2U) << quantity.name;
    EXPECT_GE(quantity.mean, *low - 1e-12) << quantity.name;
    EXPECT_LE(quantity.mean, *high + 1e-12) << quantity.name;
  }
}

TEST(Quantities, NothingIsScaledWithoutASpeed) {
  const RunFolder folder;
  std::string text = RunFolder::case_text();
  const auto stroke = text.find("stroke");
  text.erase(stroke, text.find('\n', stroke) - stroke);
  text.insert(text.find("radius"), "stroke = { kind = \"rest\" }\n");
  const RunRecord run = folder.run("a", {}, text + "[scale]\nspeed = \"0 rad/s\"\n");
  ASSERT_TRUE(run.definition);
  EXPECT_TRUE(to_json(named(run, "stress"))["scaled"].is_null());
  EXPECT_TRUE(to_json(named(run, "tub rms torque"))["scaled"].is_null());
}

TEST(Quantities, NoneBeforeTheWindow) {
  const RunFolder folder;
  folder.write("a/case.toml", RunFolder::case_text());
  folder.write("a/history.csv", RunFolder::history({}, 0.5));
  EXPECT_TRUE(find_quantities(read_run(folder.path("a"))).empty());
}

TEST(Quantities, ScatterIsTheSummarys) {
  const RunFolder folder;
  folder.run("a", {});
  folder.write("a/summary.json", R"({"cloth": {"scatter about the common centre [m]": 0.05,
      "scatter about the common centre in each cycle [m]": [0.04, 0.06, null]}})");
  const RunQuantity scatter = named(read_run(folder.path("a")), "scatter about the common centre");
  EXPECT_EQ(scatter.mean, 0.05);
  EXPECT_EQ(scatter.batches, (std::vector<double>{0.04, 0.06}));
  EXPECT_NEAR(to_json(scatter)["scaled"]["mean"].get<double>(), 2 * scatter.mean, 1e-12);
}

}  // namespace
}  // namespace washtub
