#include "case/solids.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"

using namespace washtub;
using ::testing::AllOf;
using ::testing::HasSubstr;

namespace {

/// A box of 2 m by 1 m, periodic along x, with one solid called "body".
Case with_body(const std::string& shape, const std::string& more = "",
               const std::string& sides = "x_lower = \"periodic\"\nx_upper = \"periodic\"\n") {
  return read_case_text(
      "dimension = 2\n[fluid]\nviscosity = \"1 Pa s\"\n[domain]\nsize = [\"2 m\", \"1 m\"]\n"
      "cells = [64, 32]\n[domain.sides]\n" +
          sides +
          "[time]\nend = \"1 s\"\n[[solid]]\n"
          "name = \"body\"\nshape = " +
          shape + "\n" + more,
      "body.toml");
}

std::string error_of(const std::string& shape, const std::string& more = "") {
  try {
    with_body(shape, more);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

const char* disc = "{ kind = \"sphere\", radius = \"20 cm\" }";
const char* walls = "x_lower = \"slip\"\nx_upper = \"slip\"\n";

std::string at(const std::string& x, const std::string& y = "50 cm") {
  return "centre = [\"" + x + "\", \"" + y + "\"]\n";
}

}  // namespace

TEST(PeriodicSolids, ActWithTheirImages) {
  EXPECT_EQ(build_solids(with_body(disc, at("1 m"))).size(), 1u);
  const auto solids = build_solids(with_body(disc, at("10 cm")));
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[1].body, 0u);
  EXPECT_NEAR(solids[1].centre[0], 2.1, 1e-15);
  EXPECT_EQ(solids[1].centre[1], 0.5);
  EXPECT_EQ(build_solids(with_body(disc, at("10 cm"), walls)).size(), 1u);
}

TEST(PeriodicSolids, AreWhereTheyAreAWholeNumberOfBoxesAway) {
  for (const char* x : {"0.1 m", "2.1 m", "-3.9 m", "40.1 m"}) {
    const auto solids = build_solids(with_body(disc, at(x)));
    ASSERT_EQ(solids.size(), 2u) << x;
    EXPECT_NEAR(solids[0].centre[0], 0.1, 1e-12) << x;
  }
}

/// What is long crosses the box several times; what is far from its axis acts where it is.
TEST(PeriodicSolids, MayBeLongOrFarFromTheirAxis) {
  const char* beam =
      "{ kind = \"box\", lower = [\"-2.5 m\", \"-5 cm\"], upper = [\"2.5 m\", \"5 cm\"] }";
  EXPECT_GE(build_solids(with_body(beam, at("1 m"))).size(), 3u);
  const char* far = "{ kind = \"sphere\", centre = [\"4 m\", \"0 m\"], radius = \"10 cm\" }";
  const auto solids = build_solids(with_body(far, at("1.5 m")));
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_GT(solids[1].psi({1.5, 0.5, 0}, 0), 0);
}

TEST(PeriodicSolids, WithoutEndMustBeTheSameOnBothSides) {
  const char* floor = "{ kind = \"half-space\", point = [\"0 m\", \"20 cm\"], normal = [0, 1] }";
  EXPECT_EQ(build_solids(with_body(floor)).size(), 1u);
  const char* slope = "{ kind = \"half-space\", point = [\"0 m\", \"50 cm\"], normal = [1, 4] }";
  EXPECT_THAT(error_of(slope),
              AllOf(HasSubstr("body.toml:14: solid.shape"),
                    HasSubstr("has no end along x and is not the same on both periodic x sides")));
}

TEST(SolidChecks, RefuseWhatIsOutside) {
  const std::string message =
      "solid \"body\" lies wholly outside the box and acts on nothing, "
      "allowed: what reaches into the box, from [\"0 m\", \"0 m\"] to "
      "[\"2 m\", \"1 m\"]; try another centre, or a larger domain.size";
  EXPECT_THAT(error_of(disc, at("1 m", "1.3 m")),
              AllOf(HasSubstr("body.toml:15: solid.centre"), HasSubstr(message)));
  EXPECT_THAT(error_of("{ kind = \"sphere\", centre = [\"1 m\", \"3 m\"], radius = \"2 cm\" }"),
              AllOf(HasSubstr("body.toml:14: solid.shape"), HasSubstr(message)));
  EXPECT_EQ(error_of(disc, at("1 m", "1.15 m")), "no error");
  EXPECT_NO_THROW(with_body("{ kind = \"sphere\", radius = \"1 mm\" }", at("1 m")));
}

/// A paddle that is outside at first may come in.
TEST(SolidChecks, TakeWhatTurnsIntoTheBox) {
  const std::string arm =
      "{ kind = \"sphere\", centre = [\"0 m\", \"40 cm\"], radius = \"10 cm\" }";
  const std::string turns = "drive = { kind = \"constant\", speed = \"60 rpm\" }\n";
  EXPECT_THAT(error_of(arm, at("1 m", "1.2 m")), HasSubstr("wholly outside"));
  EXPECT_EQ(error_of(arm, at("1 m", "1.2 m") + turns), "no error");
  EXPECT_THAT(error_of(arm, at("1 m", "1.6 m") + turns), HasSubstr("wholly outside"));
}

TEST(SolidChecks, RefuseWhatLeavesNoWater) {
  const char* block = "{ kind = \"box\", lower = [\"0 m\", \"0 m\"], upper = [\"2 m\", \"1 m\"] }";
  EXPECT_THAT(error_of(block), HasSubstr("solid \"body\" fills the box, which leaves no water"));
  EXPECT_THAT(error_of("{ kind = \"sphere\", radius = \"3 m\" }", at("1 m")),
              HasSubstr("fills the box"));
  const std::string half =
      "{ kind = \"box\", lower = [\"0 m\", \"0 m\"], upper = [\"2 m\", \"60 cm\"] }";
  EXPECT_EQ(error_of(half), "no error");
  EXPECT_THAT(
      error_of(half, "[[solid]]\nname = \"other\"\nshape = " + half + "\n" + at("0 m", "50 cm")),
      HasSubstr("the solids together fill the box"));
}

/// However fine the grid, the box is looked through in a moment.
TEST(SolidChecks, AreQuickOnFineGrids) {
  const char* block =
      "{ kind = \"box\", lower = [\"0 m\", \"0 m\", \"0 m\"], "
      "upper = [\"1 m\", \"1 m\", \"1 m\"] }";
  EXPECT_NO_THROW(read_case_text(
      std::string("[fluid]\nviscosity = \"1 Pa s\"\n[domain]\n"
                  "size = [\"1 m\", \"1 m\", \"1 m\"]\ncells = 8192\n[time]\nend = \"1 s\"\n"
                  "[[solid]]\nname = \"body\"\nshape = ") +
          block + "\n",
      "body.toml"));
}

TEST(SolidChecks, TakeATubAroundTheBox) {
  const char* tub =
      "{ kind = \"complement\", parts = [{ kind = \"sphere\", radius = \"50 cm\" }] }";
  EXPECT_EQ(error_of(tub, at("1 m")), "no error");
}
