#include "io/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "base/error.hpp"
#include "io/history.hpp"
#include "scratch.hpp"

namespace washtub {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

TEST(CsvTable, WhatAHistoryWrites) {
  const Scratch dir;
  History history(dir / "h.csv", {{"time", "s"}, {"tub torque", "N m"}, {"steps", ""}});
  history.add(std::vector<double>{0.5, -1.25e-7, 12});
  history.add(std::vector<double>{1, std::nan(""), 13});
  const CsvTable table = read_table(dir / "h.csv");
  EXPECT_EQ(table.rows(), 2U);
  EXPECT_EQ(table.column("tub torque").unit, "N m");
  EXPECT_EQ(table.column("tub torque [N m]").values[0], -1.25e-7);
  EXPECT_TRUE(std::isnan(table.column("tub torque").values[1]));
  EXPECT_EQ(table.column("steps").unit, "");
  EXPECT_EQ(table.find("torque"), nullptr);
  EXPECT_FALSE(table.cut());
}

TEST(CsvTable, UnfinishedLastLineIsLeftOut) {
  const CsvTable table("h.csv", "time [s],a\n1,2\n3,4");
  EXPECT_EQ(table.rows(), 1U);
  EXPECT_TRUE(table.cut());
}

TEST(CsvTable, UnitsStandLast) {
  const CsvTable table("h.csv", "time [s],drum [left] torque [N m]\n");
  EXPECT_EQ(table.columns()[1].name, "drum [left] torque");
  EXPECT_EQ(table.columns()[1].unit, "N m");
}

TEST(SoundRows, KeepTheText) {
  const std::string good = "time [s],a\n0,1\n1,\n";
  EXPECT_EQ(sound_rows(good).text, good);
  EXPECT_EQ(sound_rows(good).damaged, 0U);
  const SoundRows rows = sound_rows("time [s],a\n0,1\n,5\n1,1e\n2,3\n4,");
  EXPECT_EQ(rows.text, "time [s],a\n0,1\n2,3\n");
  EXPECT_EQ(rows.damaged, 2U);
  EXPECT_EQ(rows.first_damaged, 3U);
  EXPECT_TRUE(rows.cut);
  EXPECT_EQ(sound_rows("time").text, "");
}

TEST(CsvTable, WrongColumnNamesTheNearest) {
  const CsvTable table("h.csv", "time [s],speed [m/s]\n");
  EXPECT_THAT([&] { table.column("sped"); },
              ThrowsMessage<InputError>("h.csv: no column \"sped\", nearest: \"speed\""));
}

TEST(CsvTable, DamageIsPlaced) {
  EXPECT_THAT([] { CsvTable("h.csv", "time [s],a\n1,2\n1,x\n"); },
              ThrowsMessage<InputError>("h.csv:3: \"x\" is no number"));
  EXPECT_THAT([] { CsvTable("h.csv", "time [s],a\n1\n2,3\n"); },
              ThrowsMessage<InputError>("h.csv:2: 1 fields, expected 2"));
  EXPECT_THAT([] { CsvTable("h.csv", "time"); },
              ThrowsMessage<InputError>("h.csv: has no header line"));
  EXPECT_THAT([] { read_table("/nowhere/h.csv"); },
              ThrowsMessage<InputError>("cannot read /nowhere/h.csv: No such file or directory"));
}

}  // namespace
}  // namespace washtub
