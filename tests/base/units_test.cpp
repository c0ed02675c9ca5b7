#include "base/units.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"

using namespace washtub;

namespace {

std::string error_of(std::string_view text, const Measure& expected) {
  try {
    parse_quantity(text, expected);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Units, ConvertToSi) {
  EXPECT_DOUBLE_EQ(parse_quantity("120 rpm", measure::angular_speed), 4 * std::numbers::pi);
  EXPECT_DOUBLE_EQ(parse_quantity("4 deg", measure::angle), 4 * std::numbers::pi / 180);
  EXPECT_DOUBLE_EQ(parse_quantity("9.3e-2 kg/m^2", measure::areal_mass), 9.3e-2);
  EXPECT_DOUBLE_EQ(parse_quantity("2 mPa s", measure::viscosity), 2e-3);
  EXPECT_DOUBLE_EQ(parse_quantity("  -3mm ", measure::length), -3e-3);
  EXPECT_EQ(parse_quantity("23.76 cm", measure::length), 0.2376);
  EXPECT_EQ(parse_quantity("0 m", measure::length), 0);
}

TEST(Units, WrongOrMissingUnitNamesKindAndExample) {
  const std::string expected = "expected force per length such as \"8e5 N/m\"";
  for (const char* text : {"8e5 N", "8e5", "N/m", "", "nan N/m", "1e400 N/m"})
    EXPECT_EQ(error_of(text, measure::stiffness), expected) << text;
}

TEST(Units, UnknownOnesAreCalledSo) {
  EXPECT_EQ(error_of("1 cP", measure::viscosity),
            "unknown unit \"cP\", expected dynamic viscosity such as \"1 Pa s\"");
  EXPECT_EQ(error_of("8e5 N/blob", measure::stiffness),
            "unknown unit \"N/blob\", expected force per length such as \"8e5 N/m\"");
}

TEST(Units, ReciprocalsAreNotConverted) {
  EXPECT_NE(error_of("20 Hz", measure::time), "");
  EXPECT_NE(error_of("0.5 m", measure::curvature), "");
  EXPECT_NE(error_of("1e-5 m/N", measure::stiffness), "");
}

TEST(Units, AnglesAreADimension) {
  EXPECT_NE(error_of("2 Hz", measure::angular_speed), "");
  EXPECT_NE(error_of("2 rad/s", measure::frequency), "");
  EXPECT_EQ(error_of("2 Hz", measure::frequency), "");
}

TEST(Units, TextReadsBackExactly) {
  for (const double value : {0.31, 1.0 / 3, 4e-5, 8e5, -0.0}) {
    const std::string text = quantity_text(value, measure::length);
    EXPECT_EQ(parse_quantity(text, measure::length), value) << text;
  }
}
