#include "report/columns_index.hpp"

#include <gtest/gtest.h>

#include "record/columns.hpp"

namespace washtub {
namespace {

nlohmann::ordered_json named(const std::string& header, const std::string& name) {
  for (auto& column : columns_index(CsvTable("history.csv", header + "\n")))
    if (column["name"] == name) return column;
  return {};
}

TEST(ColumnsIndex, TakesWhatIsDeclared) {
  for (const auto& column : columns::cloth) {
    const auto index = named(std::string("time [s],") + column.about.name, column.about.name);
    EXPECT_EQ(index["meaning"], column.about.meaning);
    EXPECT_EQ(index["fold"], column.plot.fold);
    EXPECT_EQ(index["statistic"], column.plot.statistic);
  }
}

TEST(ColumnsIndex, NamesOfSolidsFollowTitlesAndLeadStatistics) {
  const std::string header = "time [s],big fin power [W],big fin torque [N m],tub torque [N m]";
  const auto power = named(header, "big fin power");
  EXPECT_EQ(power["plot"], "Power of big fin");
  EXPECT_EQ(power["statistic"], "big fin mean power");
  EXPECT_EQ(power["integral"], "Energy per cycle of big fin");
  EXPECT_EQ(power["integral_statistic"], "big fin energy per cycle");
  EXPECT_EQ(named(header, "big fin torque")["instants"], false);
  EXPECT_EQ(named(header, "tub torque")["instants"], true);
}

TEST(ColumnsIndex, LongestNameOfAColumnCounts) {
  const std::string header = "time [s],fin rms torque [N m],fin force x [N],tip x [m],salt [kg]";
  EXPECT_EQ(named(header, "fin rms torque")["curve"], "rms over the steps");
  EXPECT_EQ(named(header, "fin force x")["plot"], "Force on fin");
  EXPECT_EQ(named(header, "tip x")["fold"], "Probes");
  EXPECT_EQ(named(header, "tip x")["plot"], "tip x");
  EXPECT_TRUE(named(header, "salt").is_null());
  EXPECT_TRUE(named(header, "time").is_null());
}

}  // namespace
}  // namespace washtub
