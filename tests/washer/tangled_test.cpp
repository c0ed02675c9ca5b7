#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "washer/build.hpp"

using namespace washtub;
using ::testing::HasSubstr;

namespace {

/// Two threads of a box, the second at a height over the first.
std::string message(double height, const std::string& contact) {
  const auto sheet = [](double y) {
    return "[[cloth]]\narrangement = \"sheet\"\norigin = [\"0.2 m\", \"" + std::to_string(y) +
           " m\"]\nsize = [\"0.5 m\"]\nnodes = 9\nstretch_stiffness = \"1e3 N/m\"\n"
           "bending_stiffness = \"1e-4 N m\"\nthickness = \"1 mm\"\n";
  };
  const Case whole = read_case_text(
      "dimension = 2\n[fluid]\nviscosity = \"1 Pa s\"\n[domain]\nsize = [\"1 m\", \"1 m\"]\ncells "
      "= 32\n[time]\nend = \"1 s\"\n" +
          sheet(0.5) + sheet(0.5 + height) + "[contact]\n" + contact,
      "two");
  try {
    check_build(whole);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(TangledStart, IsRefusedWithThePairAndTheDistance) {
  EXPECT_EQ(message(0.01, ""), "");
  EXPECT_THAT(message(0.002, ""),
              HasSubstr("pieces 1 and 2 start 2 mm from each other, allowed: at least 3.12 mm "
                        "(contact.gap)"));
  EXPECT_EQ(message(0.002, "scheme = \"none\"\n"), "");
}

TEST(TangledStart, IsUntangledWhereAsked) {
  EXPECT_EQ(message(0.002, "untangle = true\n"), "");
  EXPECT_EQ(message(0, "untangle = true\n"), "");
  EXPECT_THAT(message(0, ""), HasSubstr("or contact.untangle = true"));
  EXPECT_THAT(message(0, "scheme = \"none\"\nuntangle = true\n"), HasSubstr("untangle"));
}
