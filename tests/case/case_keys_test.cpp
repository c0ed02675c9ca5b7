#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "base/error.hpp"
#include "case/case.hpp"

using namespace washtub;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

namespace {

const std::string square =
    "dimension = 2\n[domain]\nsize = [\"1 m\", \"1 m\"]\ncells = 32\n[time]\nend = \"1 s\"\n"
    "[fluid]\nviscosity = \"1 Pa s\"\n";
const std::string cube =
    "[domain]\nsize = [\"1 m\", \"1 m\", \"1 m\"]\ncells = 32\n[time]\nend = \"1 s\"\n"
    "[fluid]\nviscosity = \"1 Pa s\"\n";
const std::string thread =
    "[cloth]\nstretch_stiffness = \"8 N/m\"\nbending_stiffness = \"1e-5 N m\"\n"
    "thickness = \"1 mm\"\nsize = [\"40 cm\"]\n";

Case read_text(const std::string& text) {
  char name[] = "/tmp/washtub-case-XXXXXX";
  close(mkstemp(name));
  std::ofstream(name) << text;
  struct Cleaner {
    const char* name;
    ~Cleaner() { std::remove(name); }
  } cleaner{name};
  return read_case(name);
}

/// The error after place and key.
std::string error_of(const std::string& text) {
  try {
    read_text(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_error(const std::string& text, const std::string& part) {
  EXPECT_THAT(error_of(text), HasSubstr(part));
}

std::string sides(const std::string& keys) { return square + "[domain.sides]\n" + keys; }

}  // namespace

TEST(FluidKeys, GravityAndInitialVelocity) {
  const Case whole = read_text(square +
                               "gravity = [\"0 m/s^2\", \"-9.81 m/s^2\"]\n"
                               "velocity = [\"-6 * y\", \"3 cm/s\"]\n");
  EXPECT_EQ(whole.fluid.gravity.y(), -9.81);
  EXPECT_EQ(whole.fluid.velocity, (std::array<std::string, 3>{"-6 * y", "0.03", "0"}));
  expect_error(square + "gravity = [0, -9.81]\n", "expected acceleration with its unit");
  expect_error(square + "gravity = [\"0 m/s\", \"1 m/s\"]\n", "such as \"9.81 m/s^2\"");
  expect_error(square + "velocity = [\"z\", \"0\"]\n",
               "\"z\" is not understood; variables: x, y, r;");
  expect_error(square + "velocity = [\"t\", \"0\"]\n", "\"t\" is not understood");
  expect_error(square + "velocity = [\"x\"]\n", "expected a list of 2 formulas");
  expect_error(square + "velocity = [1, 0]\n", "expected a formula in m/s between quotes");
}

TEST(SideKeys, WaterEntersAndLeaves) {
  const std::string stream =
      "x_lower = \"inflow\"\nx_lower_velocity = [\"2 m/s\", \"0 m/s\"]\nx_upper = \"outflow\"\n"
      "y_lower = \"far-field\"\ny_upper = \"far-field\"\n";
  const Case whole = read_text(sides(stream));
  EXPECT_EQ(whole.domain.sides[0].kind, SideKind::inflow);
  EXPECT_EQ(whole.domain.sides[0].velocity.x(), 2);
  EXPECT_EQ(whole.domain.sides[1].kind, SideKind::outflow);
  EXPECT_EQ(whole.domain.sides[3].kind, SideKind::far_field);
  EXPECT_EQ(read_text(whole.resolved).resolved, whole.resolved);
}

TEST(SideKeys, RefuseStreamsThatCannotBe) {
  const std::string enters = "x_lower = \"inflow\"\nx_lower_velocity = [\"1 m/s\", \"0 m/s\"]\n";
  expect_error(sides(enters), "the water that enters cannot leave; make another side \"outflow\"");
  expect_error(sides("x_lower = \"inflow\"\nx_upper = \"outflow\"\n"),
               "missing key domain.sides.x_lower_velocity");
  expect_error(sides("x_upper = \"inflow\"\nx_lower = \"outflow\"\n"
                     "x_upper_velocity = [\"1 m/s\", \"0 m/s\"]\n"),
               "the water of an inflow must enter the box");
  expect_error(sides("x_upper = \"outflow\"\nx_upper_velocity = [\"1 m/s\", \"0 m/s\"]\n"),
               "only for a moving wall or an inflow");
  expect_error(sides("x_upper = \"far_field\"\n"), "nearest: \"far-field\"");
}

TEST(ClothKeys, Sheets) {
  const std::string sheet = square + thread + "arrangement = \"sheet\"\n";
  const Case whole =
      read_text(sheet +
                "pinned = \"r_lower\"\nclamped = [\"r_upper\"]\ncurvature = \"2 m^-1\"\n"
                "ripple = \"1 mm\"\nripples = 0.5\n");
  EXPECT_THAT(whole.cloth[0].pinned, ElementsAre(Edge::r_lower));
  EXPECT_THAT(whole.cloth[0].clamped, ElementsAre(Edge::r_upper));
  EXPECT_EQ(whole.cloth[0].curvature, 2);
  EXPECT_EQ(whole.cloth[0].ripples, 0.5);
  EXPECT_EQ(read_text(whole.resolved).resolved, whole.resolved);
  expect_error(sheet + "pinned = [\"s_lower\"]\n", "allowed in 2-D: \"r_lower\", \"r_upper\"");
  expect_error(sheet + "pinned = [\"r_left\"]\n", "expected one of \"r_lower\", \"r_upper\"");
  expect_error(sheet + "pinned = [\"r_lower\"]\nclamped = [\"r_lower\"]\n",
               "an edge is either pinned or clamped");
  expect_error(sheet + "curvature = 2\n", "expected curvature with its unit such as \"4 m^-1\"");
  expect_error(sheet + "curvature = \"15 m^-1\"\n", "the piece would meet itself");
  expect_error(sheet + "nodes = [4]\nclamped = [\"r_lower\", \"r_upper\"]\n",
               "leaves 4 nodes along r, at least 5 are needed; try more");
  expect_error(sheet + "count = 2\n", "a sheet is a single piece");
}

TEST(ClothKeys, NodesThatFollowFromTheSpacingAreBounded) {
  const std::string ring =
      square +
      "[cloth]\nstretch_stiffness = \"8 N/m\"\n"
      "bending_stiffness = \"1e-5 N m\"\nthickness = \"1 mm\"\narrangement = \"ring\"\n"
      "centre = [\"50 cm\", \"50 cm\"]\nradius = \"10 cm\"\n";
  for (const char* length : {"1 km", "1e25 m"})
    expect_error(
        ring + "size = [\"" + length + "\"]\n",
        "takes more than 4096 nodes along r at 1.7 lateral cells from one to the next "
        "(cloth.spacing); try a smaller cloth.size, a larger cloth.spacing or cloth.nodes");
}

TEST(ClothKeys, BelongToTheirArrangement) {
  const std::string random = square + thread + "arrangement = \"random\"\n";
  expect_error(random + "pinned = [\"r_lower\"]\n", "only for \"sheet\"");
  expect_error(random + "closed = true\n", "only for \"sheet\"");
  expect_error(random + "ripple = \"1 cm\"\n", "only for \"sheet\" and \"ring\"");
  expect_error(random + "radius = \"1 cm\"\n", "only for \"ring\"");
  EXPECT_EQ(read_text(random + "curvature = \"-4 m^-1\"\n").cloth[0].curvature, -4);
}

TEST(ClothKeys, Rings) {
  const std::string ring = thread + "arrangement = \"ring\"\ncentre = [\"50 cm\", \"50 cm\"]\n";
  EXPECT_EQ(read_text(square + ring + "radius = \"10 cm\"\n").cloth[0].radius, 0.1);
  expect_error(square + ring, "missing key cloth.radius");
  expect_error(square + ring + "radius = \"10 cm\"\nripple = \"1 mm\"\nripples = 1.5\n",
               "expected a whole number, since the cloth is closed");
  expect_error(cube +
                   "[cloth]\nstretch_stiffness = \"8 N/m\"\nbending_stiffness = \"1e-5 N m\"\n"
                   "thickness = \"1 mm\"\nsize = [\"40 cm\", \"10 cm\"]\n"
                   "arrangement = \"ring\"\nradius = \"10 cm\"\n",
               "a ring is a thread in the plane");
}

TEST(ClothKeys, ClosedSheetsNeedAPeriodicBox) {
  const std::string sheet = thread + "arrangement = \"sheet\"\nclosed = true\n";
  expect_error(square + sheet, "along an axis whose sides are \"periodic\"");
  const std::string periodic = sides("x_lower = \"periodic\"\nx_upper = \"periodic\"\n");
  EXPECT_TRUE(read_text(periodic + sheet).cloth[0].closed[0]);
  expect_error(periodic + sheet + "along_r = [1.0, 1.0]\n", "along an axis whose sides");
  expect_error(periodic + sheet + "pinned = [\"r_lower\"]\n", "has no edges r_lower and r_upper");
}

TEST(ClothKeys, NodesFollowHeldAndClosedEdges) {
  const std::string sheet = square + thread + "spacing = 1.6\narrangement = \"sheet\"\n";  // 5 cm
  const auto shape = [](const Case& whole) {
    return std::pair(cloth_nodes(whole.cloth[0], whole)[0],
                     cloth_spacing(whole.cloth[0], whole)[0]);
  };
  EXPECT_EQ(shape(read_text(sheet)).first, 9);
  EXPECT_NEAR(shape(read_text(sheet)).second, 0.05, 1e-15);
  const auto held = shape(read_text(sheet + "clamped = [\"r_lower\", \"r_upper\"]\n"));
  EXPECT_EQ(held.first, 10);
  EXPECT_NEAR(held.second, 0.05, 1e-15);
}

TEST(ProbeKeys, NameNodesThatExist) {
  const std::string sheet = square + thread + "nodes = [9]\narrangement = \"sheet\"\n";
  const Case whole = read_text(sheet + "[[probe]]\nname = \"tip\"\nnode = [-1]\n");
  EXPECT_EQ(whole.probes[0].node[0], -1);
  EXPECT_EQ(whole.probes[0].piece, 1);
  EXPECT_EQ(read_text(sheet + "[[probe]]\nname = \"tip\"\nnode = 8\n").probes[0].node[0], 8);
  expect_error(sheet + "[[probe]]\nname = \"tip\"\nnode = [9]\n", "allowed: -9 to 8");
  expect_error(sheet + "[[probe]]\nname = \"tip\"\nnode = [0]\npiece = 2\n",
               "there are 1 pieces of cloth");
  expect_error(sheet + "[[probe]]\nnode = [0]\n", "missing key probe.name");
  const std::string one = "[[probe]]\nname = \"tip\"\nnode = [0]\n";
  expect_error(sheet + one + one, "two probes have this name");
}

TEST(ExactKeys, VelocityOfTime) {
  const Case whole =
      read_text(square + "[exact]\nvelocity = [\"x * t\", \"r\"]\nrelative = true\n");
  ASSERT_TRUE(whole.exact.has_value());
  EXPECT_TRUE(whole.exact->relative);
  EXPECT_EQ(read_text(whole.resolved).resolved, whole.resolved);
  EXPECT_FALSE(read_text(square).exact.has_value());
  expect_error(square + "[exact]\nrelative = true\n", "missing key exact.velocity");
}

TEST(CouplingKeys, Schemes) {
  const auto scheme = [](const std::string& name) {
    return read_text(square + "[coupling]\nscheme = \"" + name + "\"\n").coupling.scheme;
  };
  EXPECT_EQ(scheme("broyden"), Scheme::broyden);
  EXPECT_EQ(scheme("implicit"), Scheme::implicit);
  expect_error(square + "[coupling]\nscheme = \"broydon\"\n", "nearest: \"broyden\"");
}

TEST(TimeKeys, SamplesAreNotCloserThanFixedSteps) {
  std::string text = square;
  text.replace(text.find("end = \"1 s\""), 11, "end = \"1 s\"\nstep = \"0.2 s\"\nfixed = true");
  expect_error(text + "[output]\nevery = \"0.1 s\"\n",
               "output.every = \"0.1 s\": allowed: at least the fixed time.step, \"0.2 s\"");
}

TEST(ClothKeys, ErrorsOfASingleListedTableNameTheirLine) {
  std::string listed = thread;
  listed.replace(0, 7, "[[cloth]]");
  expect_error(square + listed + "arrangement = \"sheet\"\npinned = \"s_lower\"\n",
               ":15: cloth.pinned = ");
}

TEST(Names, MakeNoOtherColumns) {
  const auto solid = [](const std::string& name) {
    return square + "[[solid]]\nname = " + name +
           "\nshape = { kind = \"sphere\", radius = \"0.1 m\" }\n";
  };
  EXPECT_EQ(read_text(solid("\"outer cylinder\"")).solids[0].name, "outer cylinder");
  for (const char* name : {"\"a,b\"", "\"a [m]\"", "'a\"b'", "\"a\\nb\"", "\"a\\u0001\"", "\"\""})
    expect_error(solid(name), "expected a name without comma, brackets, quotation marks");
  expect_error(square + thread + "[[probe]]\nname = \"a,b\"\nnode = [0]\n",
               "expected a name without comma");
}

TEST(ScaleKeys, NoSpeedWhereNothingMoves) {
  const Case still = read_text(square);
  EXPECT_EQ(still.scale.speed, 0);
  EXPECT_EQ(read_text(still.resolved).scale.speed, 0);
}
