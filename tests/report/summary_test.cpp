#include "io/summary.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "record/columns.hpp"
#include "record/summarise.hpp"
#include "report/statistics.hpp"
#include "support/run_folder.hpp"

namespace washtub {
namespace {

using testing::RunFolder;

/// The wash of RunFolder, recorded up to `end` [s]; its stress and torques drift, so that every
/// span has other means.
class Recorded {
 public:
  explicit Recorded(double end) {
    folder_.write("a/case.toml", RunFolder::case_text());
    whole_ = read_case(folder_.path("a/case.toml"));
    whole_.output.window_end = 3.7;  // two cycles and 0.7 of the third
    const auto columns = history_columns(whole_), paths = track_columns(whole_);
    History history(folder_.path("a/history.csv"), header(columns));
    History tracks(folder_.path("a/tracks.csv"), header(paths));
    ClothStatistics cloth(1, {1, 3.7}, 1, {0, 0});
    for (int i = 0; 0.1 * i <= end + 1e-9; ++i) {
      const Sample s = sample(0.1 * i);
      history.add(row(columns, s));
      tracks.add(row(paths, s));
      cloth.add({s.time - 0.1, s.time}, [&](ClothStatistics::Part& part) {
        part.stress.add({s.time - 0.1, s.time}, std::vector{s.stress});
      });
    }
    const CsvTable rows = read_table(folder_.path("a/history.csv"));
    const CsvTable ways = read_table(folder_.path("a/tracks.csv"));
    RunEnd at_end{"complete", end, 10 * static_cast<long>(end), 1, 2, 0, {}};
    summary = summarise(whole_, at_end, cloth, rows, &ways);
    write_summary(folder_.path("a/summary.json"), summary);
    run = read_run(folder_.path("a"));
    run.definition = whole_;
  }

  double quantity(const std::string& name) const {
    for (const RunQuantity& q : find_quantities(run))
      if (q.name == name) return q.mean;
    return std::nan("");
  }
  const nlohmann::ordered_json& solid(const std::string& name) const {
    for (const auto& solid : summary["solids"])
      if (solid["name"] == name) return solid;
    throw std::out_of_range(name);
  }
  nlohmann::ordered_json summary;
  RunRecord run;

 private:
  static Sample sample(double t) {
    Sample s;
    s.time = t;
    s.solids.resize(2);
    for (SolidSample& solid : s.solids) solid.torque = solid.friction = t * std::cos(9 * t);
    for (SolidSample& solid : s.solids) solid.rms_torque = 1 + t, solid.power = t * t;
    s.stress = {t, 1, t + 1};
    s.pieces = {{{0.1 + 0.01 * std::cos(7 * t), 0.2 + 0.01 * std::sin(7 * t)}, s.stress}};
    return s;
  }
  RunFolder folder_;
  Case whole_;
};

TEST(Summary, TellsWhereTheTimeWent) {
  const PhaseTimes times = {1, 0, 0.5, 0, 0, 2, 0, 0, 0, 0.5};
  EXPECT_EQ(phases_text(times),
            "solids 1 s (25 %), cloth 0.5 s (12 %), projection 2 s (50 %), rest 0.5 s (12 %)");
  const RunEnd end{.outcome = "complete", .phases = times};
  const Case whole;
  double seconds = 0, shares = 0;
  for (const auto& entry : entries::phases) {
    const double value = entry.take(RunSource{whole, end}).get<double>();
    (entry.about.unit.in(3) == "s" ? seconds : shares) += value;
  }
  EXPECT_DOUBLE_EQ(seconds, 4);
  EXPECT_DOUBLE_EQ(shares, 1);
  EXPECT_TRUE(Recorded(1.6).summary.contains("phases"));
}

/// The window is no whole number of cycles, and the run ends within it.
TEST(Summary, HasTheNumbersOfThePage) {
  for (const double end : {4.0, 3.4, 1.6}) {
    const Recorded r(end);
    const auto near = [&](const nlohmann::ordered_json& value, const std::string& name) {
      const double mean = r.quantity(name);
      EXPECT_NEAR(value.get<double>(), mean, 1e-8 * std::abs(mean)) << name << ' ' << end;
    };
    near(r.summary["cloth"]["stress"]["mean [Pa]"], "stress");
    near(r.summary["cloth"]["membrane stress"]["mean [Pa]"], "membrane stress");
    for (const char* name : {"tub", "agitator"})
      near(r.solid(name)["rms torque [N m]"], std::string(name) + " rms torque");
    near(r.solid("agitator")["mean power [W]"], "agitator mean power");
    if (end > 2)
      near(r.solid("agitator")["mean energy per cycle [J]"], "agitator energy per cycle");
    else
      EXPECT_FALSE(r.solid("agitator").contains("mean energy per cycle [J]"));
  }
}

TEST(Summary, TellsTheSpanOfItsStatistics) {
  const Recorded whole(4), part(1.6);
  EXPECT_EQ(whole.summary["statistics over [s]"], (std::vector<double>{1, 3}));
  EXPECT_EQ(whole.summary["whole cycles"], 2);
  EXPECT_NEAR(part.summary["statistics over [s]"][1].get<double>(), 1.6, 1e-12);
  EXPECT_EQ(part.summary["whole cycles"], 0);
}

/// Of a solid that turns the torque over all steps, of one at rest that of the rows.
TEST(Summary, RmsTorqueIsOverTheSteps) {
  const Recorded r(4);
  double steps = 0, rows = 0;
  for (int i = 11; i <= 30; ++i) {
    const double t = 0.1 * i;
    steps += (1 + t) * (1 + t) / 20, rows += std::pow(t * std::cos(9 * t), 2) / 20;
  }
  EXPECT_NEAR(r.solid("agitator")["rms torque [N m]"].get<double>(), std::sqrt(steps), 1e-7);
  EXPECT_NEAR(r.solid("tub")["rms torque [N m]"].get<double>(), std::sqrt(rows), 1e-7);
}

/// The piece goes round at 7 rad/s, from one row at the begin of the span to one at its end.
TEST(Summary, PathsAreThoseOfTheTracks) {
  const auto loop = Recorded(4).summary["cloth"]["loop"];
  EXPECT_NEAR(loop["mean turns"].get<double>(), 7 * 2 / (2 * M_PI), 0.03);
}

TEST(Summary, HasEveryDeclaredEntry) {
  const Recorded r(4);
  for (const auto& entry : entries::run)
    EXPECT_TRUE(r.summary["run"].contains(entry_name(entry.about, 3))) << entry.about.name;
  for (const auto& entry : entries::coupling)
    EXPECT_TRUE(r.summary["coupling"].contains(entry_name(entry.about, 3))) << entry.about.name;
  for (const auto& entry : entries::cloth)
    EXPECT_TRUE(r.summary["cloth"].contains(entry_name(entry.about, 3))) << entry.about.name;
}

}  // namespace
}  // namespace washtub
