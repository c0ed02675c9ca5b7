#include "record/columns.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "record/reference.hpp"

namespace washtub {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

/// A case with one of everything that has columns.
Case everything(int dimension) {
  Case whole;
  whole.dimension = dimension;
  whole.solids = {{"wall", sphere({0, 0, 0}, 1), Vec<3>::Zero(), at_rest()},
                  {"fin", sphere({0, 0, 0}, 1), Vec<3>::Zero(), constant_speed(2)}};
  whole.cloth.resize(2);
  whole.cloth[0].count = 2;
  whole.cloth[0].name = "towels";
  whole.cloth[1].name = "shirts";
  whole.cloth[1].arrangement = Arrangement::ring;
  whole.probes = {{"tip", 1, {0, 0}}};
  whole.exact = ExactCase();
  return whole;
}

Sample sample() {
  Sample s;
  s.time = 0.5;
  s.step.number = 7;
  s.solids.resize(2);
  s.solids[1].torque = -3;
  s.solids[1].rms_torque = 4;
  s.solids[0].force = {1, 2, 3};
  s.pieces.resize(3);
  for (int p = 0; p < 3; ++p) s.pieces[static_cast<std::size_t>(p)].centre = {p + 1, -(p + 1)};
  s.groups.resize(2);
  s.groups[1].stress.total = 11;
  s.probes = {{4, 5, 6}};
  s.enclosed_area = 8;
  s.error.rms = 9;
  return s;
}

/// What stands under a heading, "fin torque [N m]".
double value(const std::vector<RecordColumn>& columns, const std::string& heading) {
  const auto values = row(columns, sample());
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Column& c = columns[i].column;
    if (heading == (c.unit.empty() ? c.name : c.name + " [" + c.unit + "]")) return values[i];
  }
  throw std::out_of_range(heading);
}

std::vector<std::string> names(const std::vector<RecordColumn>& columns) {
  std::vector<std::string> all;
  for (const RecordColumn& column : columns) all.push_back(column.column.name);
  return all;
}

TEST(Columns, RowsStandUnderTheirHeadings) {
  const auto columns = history_columns(everything(3));
  EXPECT_EQ(value(columns, "time [s]"), 0.5);
  EXPECT_EQ(value(columns, "step"), 7);
  EXPECT_EQ(value(columns, "fin torque [N m]"), -3);
  EXPECT_EQ(value(columns, "fin rms torque [N m]"), 4);
  EXPECT_EQ(value(columns, "wall force z [N]"), 3);
  EXPECT_EQ(value(columns, "tip y [m]"), 5);
  EXPECT_EQ(value(columns, "shirts stress [Pa]"), 11);
  EXPECT_EQ(value(columns, "enclosed area [m^2]"), 8);
  EXPECT_EQ(value(columns, "rms velocity error [m/s]"), 9);
  EXPECT_EQ(value(track_columns(everything(3)), "piece 3 z [m]"), -3);
}

TEST(Columns, AreThoseThatTheCaseHas) {
  const auto plane = history_columns(everything(2));
  EXPECT_EQ(value(plane, "fin torque [N m/m]"), -3);
  EXPECT_EQ(value(plane, "wall force y [N/m]"), 2);
  for (const char* absent :
       {"wall power", "wall rms torque", "wall force z", "tip z", "cloth height"})
    EXPECT_THAT(names(plane), Not(Contains(absent)));
  Case one = everything(3);  // of two groups: its columns are the run's
  one.cloth[1].count = 0;
  EXPECT_THAT(names(history_columns(one)), Not(Contains("towels stress")));
  Case water = everything(3);
  water.cloth.clear();
  water.exact->relative = true;
  EXPECT_THAT(names(history_columns(water)), Not(Contains("stress")));
  EXPECT_EQ(value(history_columns(water), "rms velocity error"), 9);
  EXPECT_THAT(track_columns(water), IsEmpty());
}

/// Whatever is declared is in the header, in the row and in the documents.
TEST(Columns, OneDeclarationIsSeenEverywhere) {
  const auto history = history_columns(everything(3));
  const std::string page = output_reference();
  const auto expect = [&](const auto& declared, const std::string& owner, const std::string& of) {
    for (const auto& column : declared) {
      EXPECT_THAT(names(history), Contains(owner + column.about.name));
      EXPECT_THAT(page, HasSubstr("| `" + of + column.about.name + "` | "));
      EXPECT_THAT(page, HasSubstr(column.about.meaning));
    }
  };
  expect(columns::run, "", "");
  expect(columns::solid, "fin ", "SOLID ");
  expect(columns::error, "", "");
  expect(columns::cloth, "", "");
  expect(columns::probe, "tip ", "PROBE ");
  expect(columns::rings, "", "");
  expect(columns::group, "towels ", "GROUP ");
  EXPECT_EQ(row(history, sample()).size(), header(history).size());
}

}  // namespace
}  // namespace washtub
