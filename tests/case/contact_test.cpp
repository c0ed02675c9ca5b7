#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "case/case.hpp"

using namespace washtub;
using ::testing::HasSubstr;

namespace {

/// Twenty cells of 5 cm in a tub of water that turns at 2 rad/s.
Case contact_of(int pieces, const std::string& contact = "") {
  return read_case_text(
      "[fluid]\nviscosity = \"1 Pa s\"\ngravity = [\"0 m/s^2\", \"0 m/s^2\", \"-10 m/s^2\"]\n"
      "[washer]\nradius = \"50 cm\"\ndepth = \"50 cm\"\n[washer.stroke]\nkind = \"sinusoid\"\n"
      "peak = \"2 rad/s\"\nfrequency = \"1 Hz\"\n[domain]\nlower = [\"-50 cm\", \"-50 cm\", \"0 "
      "m\"]\n"
      "size = [\"1 m\", \"1 m\", \"50 cm\"]\ncells = 20\n"
      "[[cloth]]\ncount = " +
          std::to_string(pieces) +
          "\nsize = [\"20 cm\", \"20 cm\"]\nexcess_mass = \"3 kg/m^2\"\n"
          "stretch_stiffness = \"8e3 N/m\"\nshear_stiffness = \"1 N/m\"\n"
          "bending_stiffness = \"1e-5 N m\"\ntorsion_stiffness = \"1e-5 N m\"\nthickness = \"1 "
          "mm\"\n"
          "[time]\nend = \"1 s\"\n[contact]\n" +
          contact,
      "tub");
}

}  // namespace

/// The tub holds 0.393 m^3; the third of it is a layer of 7.5 cm over 1.745 m^2, or 43.6 pieces.
TEST(ContactCase, FollowsFromGridDriveAndLoad) {
  const ContactCase few = contact_of(43).contact, many = contact_of(44).contact;
  EXPECT_NEAR(few.range, 0.075, 1e-12);
  EXPECT_NEAR(many.range, 0.05, 1e-12);
  EXPECT_NEAR(few.gap, 0.005, 1e-12);
  EXPECT_NEAR(few.pressure, 10 * 3 * 10, 1e-9);  // rather than 1000 (2 0.5)^2 / 4
  EXPECT_NEAR(contact_of(1, "range = \"2 mm\"\n").contact.gap, 0.001, 1e-12);  // half the range
}

TEST(ContactCase, RefusesAGapAsWideAsTheRange) {
  try {
    contact_of(1, "range = \"2 cm\"\ngap = \"2 cm\"\n");
    FAIL() << "read";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("allowed: a gap below the range"));
  }
  contact_of(1, "scheme = \"none\"\nrange = \"2 cm\"\ngap = \"2 cm\"\n");
}
