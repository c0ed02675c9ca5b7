#include "report/quantities.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "measure/cycles.hpp"
#include "report/run_folder.hpp"

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
  EXPECT_NEAR(stress.mean, 1.8, 1e-9);  // of the values at 1.1, 1.2, ..., 2.5
  EXPECT_TRUE(to_json(stress)["half_width"].is_null());
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
  EXPECT_EQ(to_json(scatter)["scaled"]["mean"], 0.1);
}

}  // namespace
}  // namespace washtub
