#include "solid/agitator.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "samples.hpp"

namespace washtub {
namespace {

constexpr double r_o = 0.31, H = 0.2376;

Vec<3> polar(double r, double degrees, double z) {
  const double a = degrees * std::numbers::pi / 180;
  return {r * std::cos(a), r * std::sin(a), z};
}

TEST(Agitator3d, ReferenceHasItsPartsWhereTheyBelong) {
  const Shape s = shape(reference_agitator_3d(r_o, H));
  const auto inside = [&](double r, double degrees, double z) {
    return s.psi(polar(r * r_o, degrees, z * H)) > 0;
  };
  EXPECT_TRUE(inside(0.69, 60, 0.039) && !inside(0.71, 60, 0.01));  // rim of the skirt
  EXPECT_TRUE(inside(0.41, 60, 0.36) && !inside(0.41, 60, 0.38));   // its slope: 0.37 H there
  EXPECT_TRUE(inside(0.11, 60, 0.74) && !inside(0.14, 60, 0.74));   // hub
  EXPECT_TRUE(inside(0, 0, 0.75 + 0.11 * r_o / H));                 // cap
  EXPECT_FALSE(inside(0, 0, 0.75 + 0.13 * r_o / H));
  EXPECT_TRUE(inside(0.44, 0, 0.45) && !inside(0.46, 0, 0.45));        // fin's outer edge
  EXPECT_TRUE(inside(0.285, 120, 0.59) && !inside(0.285, 120, 0.61));  // top edge: 0.60 H there
  EXPECT_FALSE(inside(0.285, 180, 0.59));                              // between two fins
}

TEST(Agitator3d, TurnedByAThirdItIsTheSame) {
  const Shape s = shape(reference_agitator_3d(r_o, H));
  const Shape turned = rotate_z(s, 2 * std::numbers::pi / 3);
  Points points(r_o);
  for (int i = 0; i < 1000; ++i) {
    const Vec<3> x = points.next();
    EXPECT_NEAR(s.psi(x), turned.psi(x), 1e-14);
  }
}

TEST(Agitator3d, FloorIsNoFaceOfIt) {
  const Shape s = shape(reference_agitator_3d(r_o, H));
  EXPECT_LT(s.bounds().lower[2], -0.5 * r_o);
  const Vec<3> above = polar(0.3 * r_o, 60, 1e-3 * H), up(0, 0, 1e-3);
  EXPECT_LT(s.psi(above + up), s.psi(above));
}

TEST(Agitator2d, ReferenceDiscAndFins) {
  const Shape s = shape(reference_agitator_2d(r_o));
  EXPECT_NEAR(s.psi(polar(0.3 * r_o, 120, 0)), 0.035 * r_o, 1e-15);
  EXPECT_NEAR(s.psi(polar(0.7 * r_o, 240, 0)), -0.045 * r_o, 1e-15);
  EXPECT_NEAR(s.psi(polar(0.1 * r_o, 60, 0)), 0.06 * r_o, 1e-15);
  EXPECT_LT(s.psi(polar(0.3 * r_o, 60, 0)), 0);
}

TEST(Agitator, WithoutFinsItIsRound) {
  Agitator3d a = reference_agitator_3d(r_o, H);
  a.fins = 0;
  EXPECT_NEAR(shape(a).psi(polar(0.3, 0, 0.1)), shape(a).psi(polar(0.3, 77, 0.1)), 1e-15);
}

TEST(Agitator, ImpossibleParametersAreNamed) {
  using ::testing::HasSubstr;
  using ::testing::ThrowsMessage;
  const auto changed = [](auto change) {
    return [change] {
      Agitator3d a = reference_agitator_3d(r_o, H);
      change(a);
      shape(a);
    };
  };
  EXPECT_THAT(changed([](Agitator3d& a) { a.fins = -1; }),
              ThrowsMessage<InputError>(HasSubstr("fins = -1")));
  EXPECT_THAT(changed([](Agitator3d& a) { a.hub_radius = 0; }),
              ThrowsMessage<InputError>(HasSubstr("hub_radius = 0 m")));
  EXPECT_THAT(changed([](Agitator3d& a) { a.skirt_top_radius = 1; }),
              ThrowsMessage<InputError>(HasSubstr("less than rim_radius")));
  EXPECT_THAT([] { shape(Agitator2d{.hub_radius = 1, .fins = 2, .fin_radius = 1}); },
              ThrowsMessage<InputError>(HasSubstr("fin_half_width")));
}

}  // namespace
}  // namespace washtub
