#include "case/resolution.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace washtub {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A plane box of 1 m and 32 x 32 cells of 31.25 mm.
Case plane(std::vector<SolidCase> solids) {
  Case whole;
  whole.dimension = 2;
  whole.domain.size = {1, 1, 0};
  whole.domain.cells = {32, 32, 1};
  whole.solids = std::move(solids);
  return whole;
}

SolidCase solid(const std::string& name, const Shape& shape) { return {name, shape}; }

Shape bar(double x_lower, double x_upper) { return box({x_lower, 0.2, -1}, {x_upper, 0.8, 1}); }

TEST(Resolution, ThickSolidsFarApartAreResolved) {
  EXPECT_THAT(unresolved(plane({})), IsEmpty());
  EXPECT_THAT(unresolved(plane({solid("post", sphere({0.5, 0.5, 0}, 0.2))})), IsEmpty());
  EXPECT_THAT(unresolved(plane({solid("bar", bar(0.1, 0.2)), solid("other", bar(0.5, 0.6))})),
              IsEmpty());
}

TEST(Resolution, ThinPartsAreNamed) {
  EXPECT_THAT(unresolved(plane({solid("fin", bar(0.3, 0.35))})),
              ElementsAre("fin has parts about 1.6 cells thick, at least 2 are resolved; try 1.3 "
                          "times as many domain.cells"));
}

TEST(Resolution, NarrowGapsAreNamed) {
  EXPECT_THAT(unresolved(plane({solid("one", bar(0.2, 0.3)), solid("two", bar(0.4, 0.5))})),
              ElementsAre("one leaves gaps to other solids about 3.2 cells wide, at least 4 are "
                          "resolved; try 1.3 times as many domain.cells",
                          "two leaves gaps to other solids about 3.2 cells wide, at least 4 are "
                          "resolved; try 1.3 times as many domain.cells"));
}

/// The cells of a wash are three times as wide as high: a fin counts the wide ones.
TEST(Resolution, CountsCellsAcross) {
  const auto found = unresolved(read_case("cases/wash-3d/case.toml"));
  EXPECT_THAT(found, ElementsAre(HasSubstr("agitator has parts about 1.0 cells thick")));
  EXPECT_THAT(unresolved(read_case("cases/wash-3d/case.toml", {"domain.cells=72"})), IsEmpty());
}

TEST(Resolution, TheCoarsePlaneWashIsNotResolved) {
  EXPECT_THAT(unresolved(read_case("cases/wash-2d/case.toml", {"domain.cells=32"})),
              ElementsAre(HasSubstr("agitator has parts about 1.1 cells thick")));
  EXPECT_THAT(unresolved(read_case("cases/wash-2d/case.toml")), IsEmpty());
}

}  // namespace
}  // namespace washtub
