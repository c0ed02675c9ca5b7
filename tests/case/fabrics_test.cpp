#include "case/fabrics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "case/case.hpp"

using namespace washtub;
using ::testing::HasSubstr;

namespace {

std::string text(const std::string& cloth, const std::string& more = "") {
  return "[washer]\nradius = \"31 cm\"\ndepth = \"30 cm\"\n[fluid]\nviscosity = \"1 mPa s\"\n"
         "[domain]\ncells = 32\n[[cloth]]\nsize = [\"10 cm\", \"10 cm\"]\n" +
         cloth + more + "[time]\nend = \"1 s\"\n";
}

ClothCase cloth_of(const std::string& cloth) { return read_case_text(text(cloth), "it").cloth[0]; }

std::string error_of(const std::string& cloth) {
  try {
    cloth_of(cloth);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Fabrics, GiveWhatTheCaseDoesNot) {
  const ClothCase cloth = cloth_of("fabric = \"cotton sheet\"\nfriction = 0.3\n");
  EXPECT_EQ(cloth.material.stretch, 3000);
  EXPECT_EQ(cloth.material.bending, 1e-5);
  EXPECT_EQ(cloth.material.friction, 0.3);
  EXPECT_NEAR(cloth.material.excess_mass, 0.150 * (1 - 1000.0 / 1540), 1e-12);
  // 150 mm/s of air at 100 Pa, in water of 1 mPa s
  EXPECT_NEAR(cloth.material.permeability, 0.018 * 0.150 / 100, 1e-12);
  EXPECT_EQ(cloth.name, "cloth");
}

/// Every one is a valid cloth, has a source or "typical" to each value, and reads back the same.
TEST(Fabrics, AreWhole) {
  EXPECT_GE(fabrics().size(), 8U);
  for (const Fabric& fabric : fabrics()) {
    const std::string name = "fabric = \"" + fabric.name + "\"\n";
    const Case whole = read_case_text(text(name), "it");
    EXPECT_GT(whole.cloth[0].material.permeability, 0) << fabric.name;
    EXPECT_EQ(read_case_text(whole.resolved, "again").resolved, whole.resolved);
    for (const FabricValue& value : fabric.values) EXPECT_FALSE(value.source.empty());
    EXPECT_THAT(fabric_reference(), HasSubstr("| " + fabric.name + " |"));
    EXPECT_THAT(fabric_text(fabric), HasSubstr("# typical"));
  }
}

TEST(Fabrics, ServeThreadsToo) {
  const Case whole = read_case_text(
      "dimension = 2\n[washer]\nradius = \"31 cm\"\n[fluid]\nviscosity = \"1 Pa s\"\n[domain]\n"
      "cells = 64\n[[cloth]]\nsize = [\"20 cm\"]\nfabric = \"denim\"\n[time]\nend = \"1 s\"\n",
      "it");
  EXPECT_EQ(whole.cloth[0].material.stretch, 2600);
  EXPECT_EQ(whole.cloth[0].material.stretch_beyond, 11000);
  EXPECT_EQ(whole.cloth[0].material.knee, 0.01);
  EXPECT_EQ(whole.cloth[0].material.shear, 0);
}

TEST(Groups, HaveNamesOfTheirOwn) {
  const auto two = [](const std::string& first) {
    return text("fabric = \"denim\"\n" + first,
                "[[cloth]]\nsize = [\"10 cm\", \"10 cm\"]\nfabric = \"trousers\"\n");
  };
  const Case whole = read_case_text(two(""), "it");
  EXPECT_EQ(whole.cloth[0].name, "cloth 1");
  EXPECT_EQ(whole.cloth[1].name, "cloth 2");
  for (const char* taken : {"cloth 2", "agitator"}) try {
      read_case_text(two("name = \"" + std::string(taken) + "\"\n"), "it");
      FAIL() << taken;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a solid or another group of cloth has this name"));
    }
}

/// What is stiffer beyond a strain goes with the stiffness below it.
TEST(Fabrics, StretchIsTakenAsAWhole) {
  const ClothCase given = cloth_of("fabric = \"denim\"\nstretch_stiffness = \"8e5 N/m\"\n");
  EXPECT_EQ(given.material.stretch, 8e5);
  EXPECT_TRUE(std::isinf(given.material.knee));
  const ClothCase both =
      cloth_of("fabric = \"denim\"\nkes = { B = 0.2, G = 2, LT = 1, EMT = 5 }\n");
  EXPECT_NEAR(both.material.stretch, 9807, 1);
  EXPECT_TRUE(std::isinf(both.material.knee));
}

TEST(Stretch, BeyondAKneeIsRefusedWhereItMakesNoSense) {
  const std::string rest = "fabric = \"t-shirt jersey\"\n";
  EXPECT_THAT(error_of(rest + "knee = 0.02\n"), HasSubstr("expected stiffness_beyond along with"));
  EXPECT_THAT(error_of(rest + "stiffness_beyond = \"100 N/m\"\n"),
              HasSubstr("allowed: from stretch_stiffness, \"300 N/m\", on"));
  EXPECT_EQ(cloth_of(rest + "stiffness_beyond = \"1000 N/m\"\n").material.knee, 0.01);
}

TEST(Fabrics, AreNamedWhereOneDoesNotExist) {
  EXPECT_THAT(error_of("fabric = \"cotton sheets\"\n"),
              AllOf(HasSubstr("it:10: cloth.fabric"), HasSubstr("nearest: \"cotton sheet\"")));
}

/// B = 0.2 gf cm^2/cm is 19.6 uN m, G = 2 gf/(cm deg) is 112.4 N/m. EMT = 5 % and LT = 0.7 make
/// N = 490.3 (e/0.05)^1.857, which is 24.7 N/m at 1 %.
TEST(Readings, OfKawabataAreConverted) {
  const ClothCase cloth = cloth_of(
      "thickness = \"0.5 mm\"\npermeability = \"1e-5 m/(s Pa)\"\n"
      "kes = { B = 0.2, G = 2, LT = 0.7, EMT = 5 }\n");
  EXPECT_NEAR(cloth.material.bending, 19.61e-6, 0.01e-6);
  EXPECT_NEAR(cloth.material.torsion, 19.61e-6, 0.01e-6);
  EXPECT_NEAR(cloth.material.shear, 112.4, 0.1);
  EXPECT_NEAR(cloth.material.stretch, 2468, 1);
  EXPECT_NEAR(cloth.material.stretch_beyond, 11641, 2);
  EXPECT_NEAR(cloth.material.knee, 0.01, 1e-12);
  EXPECT_EQ(cloth.material.permeability, 1e-5);
}

/// A bending length of 20 mm at 150 g/m^2 is 11.8 uN m; 1 % between 5 and 20 gf/cm is 1471 N/m.
TEST(Readings, OfFastAreConverted) {
  const ClothCase cloth = cloth_of(
      "thickness = \"0.5 mm\"\nfast = { W = 150, C = 20, E5 = 0.5, E20 = 1.5, EB5 = 2 }\n");
  EXPECT_NEAR(cloth.material.bending, 11.77e-6, 0.01e-6);
  EXPECT_NEAR(cloth.material.shear, 61.5, 1e-9);
  EXPECT_NEAR(cloth.material.stretch, 1471, 1);
  EXPECT_NEAR(cloth.material.excess_mass, 0.150 * (1 - 1000.0 / 1540), 1e-9);
}

TEST(Readings, OutOfRangeAreRefused) {
  EXPECT_THAT(error_of("thickness = \"1 mm\"\nkes = { B = 0.2, G = 2, LT = 7, EMT = 5 }\n"),
              AllOf(HasSubstr("cloth.kes.LT = 7"), HasSubstr("allowed: 0.3 to 1.2")));
  EXPECT_THAT(error_of("thickness = \"1 mm\"\nkes = { G = 2, LT = 0.7, EMT = 5 }\n"),
              HasSubstr("missing key cloth.kes.B"));
  EXPECT_THAT(
      error_of("thickness = \"1 mm\"\nfast = { W = 150, C = 20, E5 = 2, E20 = 1, EB5 = 2 }\n"),
      HasSubstr("allowed: above E5"));
}
