#include "case/groups.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "case/description.hpp"

namespace washtub {
namespace {

/// Lengths and speeds whose powers are easily told apart.
Case simple() {
  Case whole;
  whole.dimension = 3;
  whole.fluid.density = 10;
  whole.fluid.viscosity = 4;
  whole.domain.size = {2, 2, 3};
  whole.domain.cells = {8, 8, 4};
  whole.scale = {2, 3, 5, 0.25};
  ClothCase cloth;
  cloth.material = {720, 72, 2880, 288, 0, 4, 1e-3};
  whole.cloth = {cloth};
  return whole;
}

double value(const std::vector<Group>& groups, const std::string& name) {
  for (const Group& group : groups)
    if (group.name == name) return group.value;
  ADD_FAILURE() << "no " << name;
  return 0;
}

TEST(Groups, AsThePaperDefinesThem) {
  const auto found = groups(simple());
  EXPECT_DOUBLE_EQ(value(found, "Re"), 10 * 3 * 4 / 4.0);
  EXPECT_DOUBLE_EQ(value(found, "St"), 1 / (0.25 * 3));
  EXPECT_DOUBLE_EQ(value(found, "Te"), 1);  // over 10 x 9 x 8
  EXPECT_DOUBLE_EQ(value(found, "Se"), 0.1);
  EXPECT_DOUBLE_EQ(value(found, "Be"), 1);  // over 10 x 9 x 32
  EXPECT_DOUBLE_EQ(value(found, "To"), 0.1);
  EXPECT_DOUBLE_EQ(value(found, "In"), 0.2);
  EXPECT_DOUBLE_EQ(value(found, "Re_h"), 10 * 6 * 0.75 / 4.0);
}

TEST(Groups, OfDifferentClothAreNamed) {
  Case whole = simple();
  whole.cloth.push_back(whole.cloth[0]);
  whole.cloth[1].name = "towels";
  EXPECT_DOUBLE_EQ(value(groups(whole), "Te"), 1);
  whole.cloth[1].material.stretch *= 2;
  EXPECT_DOUBLE_EQ(value(groups(whole), "Te of towels"), 2);
}

TEST(Groups, NoneWithoutASpeed) {
  Case still = simple();
  still.scale.speed = 0;
  EXPECT_TRUE(groups(still).empty());
  EXPECT_FALSE(scales(still));
}

TEST(Scales, OfStressAndTorque) {
  EXPECT_DOUBLE_EQ(scales(simple())->stress, 10 * 4 * 9);
  EXPECT_DOUBLE_EQ(scales(simple())->torque, 10 * 16 * 9 * 5);
  Case flat = simple();
  flat.dimension = 2;
  EXPECT_DOUBLE_EQ(scales(flat)->torque, 10 * 16 * 9);
}

TEST(Description, SidesOfTheBox) {
  Case whole = simple();
  whole.domain.sides[1] = {SideKind::moving_wall, {0, 0.5, 0}};
  whole.domain.sides[5].kind = SideKind::slip;
  EXPECT_EQ(sides_text(whole),
            "x no-slip (lower) and moving-wall (0, 0.5, 0) m/s (upper), y no-slip, z no-slip "
            "(lower) and slip (upper)");
}

TEST(Description, HowFarAStrokeGoes) {
  const double pi = std::numbers::pi;
  EXPECT_EQ(drive_text(at_rest()), "at rest");
  EXPECT_EQ(drive_text(constant_speed(2 * pi)), "turns at up to 60 rpm");
  EXPECT_EQ(drive_text(sinusoid(pi * pi, 1)),
            "turns at up to 94.2478 rpm, period 1 s, 180 deg to and fro");
  EXPECT_EQ(drive_text(stroke_table({0, 1, 2}, {0, pi, 0}, true)),
            "turns at up to 30 rpm, period 2 s");
}

}  // namespace
}  // namespace washtub
