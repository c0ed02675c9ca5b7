#include "case/case.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <numbers>

#include "base/error.hpp"

using namespace washtub;

namespace {

constexpr double pi = std::numbers::pi;
const char* wash = "cases/wash-3d/case.toml";

/// Reads a case from text; where it says nothing about the water, that is not what is tested.
Case read_text(const std::string& text) {
  char name[] = "/tmp/washtub-case-XXXXXX";
  close(mkstemp(name));
  const bool has_water = text.find("viscosity") != std::string::npos;
  std::ofstream(name) << text << (has_water ? "" : "\n[fluid]\nviscosity = \"1 Pa s\"\n");
  struct Cleaner {
    const char* name;
    ~Cleaner() { std::remove(name); }
  } cleaner{name};
  return read_case(name);
}

const std::string flat_washer =
    "dimension = 2\n[washer]\nradius = \"1 m\"\n[domain]\ncells = 64\n[time]\nend = \"1 s\"\n";

}  // namespace

TEST(WasherTable, FillsTheReferenceWash) {
  const Case whole = read_case(wash);
  EXPECT_NEAR(whole.domain.size.x(), 0.7128, 1e-12);
  EXPECT_NEAR(whole.domain.size.z(), 0.2376, 1e-12);
  EXPECT_NEAR(whole.domain.lower.y(), -0.3564, 1e-12);
  EXPECT_EQ(whole.domain.sides[4].kind, SideKind::no_slip);
  EXPECT_EQ(whole.domain.sides[5].kind, SideKind::slip);
  EXPECT_NEAR(whole.scale.speed, 4 * pi, 1e-12);
  EXPECT_NEAR(whole.scale.period, pi / 2, 1e-12);
  EXPECT_NEAR(whole.time.step * whole.scale.speed, 5e-3, 1e-15);
  ASSERT_EQ(whole.cloth.size(), 1u);
  EXPECT_NEAR(whole.cloth[0].inner_radius, 0.148, 1e-12);
  EXPECT_NEAR(whole.cloth[0].bottom, 0.078, 1e-12);
  EXPECT_NEAR(whole.cloth[0].tilt, 4 * pi / 180, 1e-12);
}

TEST(WasherTable, MakesTubAndAgitator) {
  const Case whole = read_case(wash);
  ASSERT_EQ(whole.solids.size(), 2u);
  const SolidCase& tub = whole.solids[0];
  const SolidCase& agitator = whole.solids[1];
  EXPECT_NEAR(tub.shape.psi({0.30, 0, 0.1}), -0.01, 1e-12);
  EXPECT_FALSE(tub.drive.moving());
  EXPECT_GT(agitator.shape.psi({0.21, 0.0, 0.005}), 0);     // the skirt's rim
  EXPECT_LT(agitator.shape.psi({0.23, 0.0, 0.005}), 0);     // beyond it
  EXPECT_GT(agitator.shape.psi({0.135, 0.0, 0.1}), 0);      // a fin
  EXPECT_LT(agitator.shape.psi({-0.135, 0.0, 0.1}), 0);     // between two
  EXPECT_NEAR(agitator.drive.angle(pi / 4), 2 * pi, 1e-9);  // half a stroke
}

TEST(WasherTable, OtherKeysWin) {
  const Case whole =
      read_case(wash, {"washer.radius=40 cm", "domain.lower=[\"-1 m\", \"-1 m\", \"0 m\"]",
                       "domain.size=[\"2 m\", \"2 m\", \"30 cm\"]", "cloth.bottom=1 cm",
                       "domain.cells=64", "time.step=1 ms", "scale.length=1 m"});
  EXPECT_EQ(whole.domain.size.x(), 2);
  EXPECT_NEAR(whole.cloth[0].inner_radius, 0.148 * 40 / 31, 1e-12);
  EXPECT_EQ(whole.cloth[0].bottom, 0.01);
  EXPECT_EQ(whole.time.step, 1e-3);
  EXPECT_EQ(whole.scale.length, 1);
}

TEST(WasherTable, FlatWasher) {
  const Case whole = read_text(flat_washer);
  EXPECT_NEAR(whole.domain.size.x(), 2.171, 1e-12);
  EXPECT_EQ(whole.domain.cells[1], 64);
  EXPECT_EQ(whole.domain.cells[2], 1);
  EXPECT_GT(whole.solids[1].shape.psi({0.65, 0, 0}), 0);  // round end of a fin
  EXPECT_LT(whole.solids[1].shape.psi({0.66, 0, 0}), 0);
  EXPECT_EQ(whole.scale.height, 1);
  EXPECT_THROW(read_text(flat_washer + "[washer.agitator]\nrim_radius = \"1 cm\"\n"), InputError);
}

TEST(WasherTable, NamedSolidReplacesTheWashers) {
  const Case whole = read_text(flat_washer +
                               "[[solid]]\nname = \"agitator\"\n"
                               "shape = { kind = \"sphere\", radius = \"10 cm\" }\n"
                               "drive = { kind = \"constant\", speed = \"60 rpm\" }\n");
  ASSERT_EQ(whole.solids.size(), 2u);
  EXPECT_NEAR(whole.solids[1].shape.psi({0, 0, 0}), 0.1, 1e-12);
  EXPECT_NEAR(whole.scale.speed, 2 * pi, 1e-12);
}

TEST(Case, ResolvedTextReadsBackTheSame) {
  for (const char* path : {wash, "cases/couette/case.toml"}) {
    const Case whole = read_case(path);
    EXPECT_EQ(read_text(whole.resolved).resolved, whole.resolved);
  }
}

TEST(Case, ShapesCombine) {
  const Case whole = read_text(
      "dimension = 2\n[domain]\nsize = [\"1 m\", \"1 m\"]\ncells = [16, 8]\n[time]\nend = \"1 s\"\n"
      "[[solid]]\nname = \"ring\"\ncentre = [\"50 cm\", \"50 cm\"]\n"
      "shape = { kind = \"difference\", parts = [\n"
      "  { kind = \"sphere\", radius = \"20 cm\" },\n"
      "  { kind = \"box\", lower = [\"-5 cm\", \"-5 cm\"], upper = [\"5 cm\", \"5 cm\"] }] }\n");
  const Shape& ring = whole.solids[0].shape;
  EXPECT_LT(ring.psi({0, 0, 0}), 0);
  EXPECT_GT(ring.psi({0.1, 0, 0}), 0);
  EXPECT_LT(ring.psi({0.21, 0, 0}), 0);
}

TEST(Case, NodesFollowTheGrid) {
  EXPECT_EQ(cloth_nodes(read_case(wash).cloth[0], read_case(wash)), (std::array<int, 2>{5, 5}));
  const Case fine = read_case(wash, {"domain.cells=64"});
  EXPECT_EQ(cloth_nodes(fine.cloth[0], fine), (std::array<int, 2>{9, 9}));
  const Case given = read_case(wash, {"cloth.nodes=[7, 8]"});
  EXPECT_EQ(cloth_nodes(given.cloth[0], given), (std::array<int, 2>{7, 8}));
}

TEST(Case, WallsMoveAlongThemselves) {
  const std::string box =
      "dimension = 2\n[domain]\nsize = [\"1 m\", \"1 m\"]\ncells = 16\n[time]\nend = \"1 s\"\n"
      "[domain.sides]\ny_upper = \"moving-wall\"\n";
  EXPECT_THROW(read_text(box), InputError);
  EXPECT_THROW(read_text(box + "y_upper_velocity = [\"0 m/s\", \"1 m/s\"]\n"), InputError);
  const Case whole = read_text(box + "y_upper_velocity = [\"1 m/s\", \"0 m/s\"]\n");
  EXPECT_EQ(whole.domain.sides[3].velocity.x(), 1);
  EXPECT_EQ(whole.scale.speed, 2);  // wall speed over half the box
}
