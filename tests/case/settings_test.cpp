#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <numbers>

#include "base/error.hpp"
#include "case/case.hpp"

using namespace washtub;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

namespace {

constexpr const char* wash = "cases/wash-3d/case.toml";
constexpr double rpm = std::numbers::pi / 30;

const std::string washer =
    "[fluid]\nviscosity = \"1 Pa s\"\n[domain]\ncells = 32\n[time]\nend = \"4 s\"\n"
    "[washer]\nradius = \"31 cm\"\ndepth = \"24 cm\"\n";
const std::string speeds =
    "[washer.stroke]\nkind = \"table\"\ntimes = [\"0 s\", \"1 s\", \"2 s\"]\n";
const std::string page =
    "[cloth]\nstretch_stiffness = \"8e5 N/m\"\nbending_stiffness = \"1e-5 N m\"\n"
    "thickness = \"1 mm\"\n";

Case read_text(const std::string& text, const std::vector<std::string>& settings = {}) {
  char name[] = "/tmp/washtub-case-XXXXXX";
  close(mkstemp(name));
  std::ofstream(name) << text;
  struct Cleaner {
    const char* name;
    ~Cleaner() { std::remove(name); }
  } cleaner{name};
  return read_case(name, settings);
}

template <class Read>
std::string error_when(Read&& read) {
  try {
    read();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

std::string error_of(const std::string& text, const std::vector<std::string>& settings = {}) {
  return error_when([&] { read_text(text, settings); });
}

}  // namespace

TEST(KindSettings, NameTheKeysOfAnotherKind) {
  const std::string text = washer + speeds + "speeds = [\"0 rpm\", \"9 rpm\", \"0 rpm\"]\n";
  const std::vector<std::string> sine = {"washer.stroke.kind=sinusoid",
                                         "washer.stroke.peak=100 rpm"};
  EXPECT_THAT(error_of(text, sine),
              HasSubstr("washer.stroke.times = [\"0 s\", \"1 s\", \"2 s\"]: a key of kind "
                        "\"table\", but the kind is \"sinusoid\" (--set); the whole table is "
                        "replaced by --set 'washer.stroke={ kind = \"sinusoid\", peak = "
                        "\"100 rpm\", frequency = ... }'"));
  const Case replaced = read_text(
      text, {"washer.stroke={ kind = \"sinusoid\", peak = \"100 rpm\", frequency = \"0.5 Hz\" }"});
  EXPECT_NEAR(replaced.solids[1].drive.peak(), 100 * rpm, 1e-12);
  const Case taken_out = read_text(text, {sine[0], sine[1], "washer.stroke.frequency=0.5 Hz",
                                          "washer.stroke.times=", "washer.stroke.speeds="});
  EXPECT_NEAR(taken_out.solids[1].drive.period(), 2, 1e-12);
}

TEST(KindSettings, NameTheKeysOfAnotherKindOfShape) {
  const std::string ball = washer +
                           "[[solid]]\nname = \"ball\"\nshape = { kind = \"sphere\", radius = \"1 "
                           "cm\" }\ndrive = { kind = \"constant\", speed = \"1 rpm\" }\n";
  EXPECT_THAT(error_of(ball, {"solid.shape.kind=cylinder", "solid.shape.a=[1, 1, 1]"}),
              HasSubstr("solid.shape.a = [1, 1, 1]: a key of kind \"capsule\", but the kind is "
                        "\"cylinder\" (--set); the whole table is replaced by --set "
                        "'solid.shape={ kind = \"cylinder\", radius = \"1 cm\" }'"));
  EXPECT_THAT(error_of(ball, {"solid.drive.kind=rest"}),
              HasSubstr("solid.drive.speed = \"1 rpm\": a key of kind \"constant\""));
  EXPECT_THAT(error_of(ball, {"solid.shape.colour=red"}), HasSubstr("unknown key"));
}

TEST(KindSettings, ChangeTheDefaultStroke) {
  const Case faster = read_text(washer, {"washer.stroke.peak=100 rpm"});
  EXPECT_NEAR(faster.solids[1].drive.peak(), 100 * rpm, 1e-12);
  EXPECT_NEAR(faster.solids[1].drive.period(), std::numbers::pi / 2, 1e-12);
  EXPECT_THAT(error_of(washer, {"washer.stroke.speed=100 rpm"}),
              HasSubstr("a key of kind \"constant\", but the kind is \"sinusoid\" (the default)"));
  EXPECT_THAT(error_of(washer, {"washer.stroke.peak=100 Hz"}),
              HasSubstr("--set washer.stroke.peak = \"100 Hz\": expected angular speed"));
}

TEST(KindSettings, TakeOutKeysOfAnotherArrangement) {
  const std::string text = washer + page +
                           "size = [\"10 cm\", \"10 cm\"]\narrangement = \"random\"\n"
                           "clearance = \"1 mm\"\n";
  const std::string sheet = "cloth.arrangement=sheet";
  EXPECT_THAT(
      error_of(text, {sheet}),
      HasSubstr("cloth.clearance = \"1 mm\": only for \"book\", \"random\", \"dropped\" and "
                "\"layers\"; --set cloth.clearance= takes it out"));
  EXPECT_EQ(read_text(text, {sheet, "cloth.clearance="}).cloth[0].arrangement, Arrangement::sheet);
  EXPECT_EQ(error_of(text, {"cloth.tilt="}),
            "--set cloth.tilt=: the case file does not give it, so it cannot be taken out");
}

TEST(AnySettings, ReadBackFromTheResolvedCase) {
  const Case whole = read_text(washer, {"title=bell \a and\ttab", "fluid.viscosity=2 Pa s"});
  EXPECT_EQ(whole.title, "bell \a and\ttab");
  EXPECT_EQ(read_case_text(whole.resolved, "case.toml").resolved, whole.resolved);
}

TEST(AnySettings, AreRefusedWhereTheyLeadBeyondAllNumbers) {
  EXPECT_THAT(error_of(washer, {"washer.radius=1e31 m"}),
              HasSubstr("expected length up to 1e+30 m"));
  EXPECT_THAT(error_of(washer, {"washer.radius=9e29 m", "washer.depth=9e29 m"}),
              HasSubstr("washer.radius = \"9e29 m\": leads to a box wider than 1e+30 m"));
  const std::string stream =
      "dimension = 2\n[domain]\nsize = [\"1e-9 m\", \"1 m\"]\ncells = 32\n"
      "[time]\nend = \"1 s\"\n[fluid]\nviscosity = \"1 Pa s\"\n[domain.sides]\n"
      "x_lower = \"inflow\"\nx_upper = \"outflow\"\n"
      "x_lower_velocity = [\"1e29 m/s\", \"0 m/s\"]\n";
  EXPECT_THAT(error_of(stream),
              HasSubstr("scale.speed = \"2e+38 rad/s\" (default): allowed: up to \"1e+30 rad/s\"; "
                        "try a larger scale.length"));
  EXPECT_THAT(error_of(washer, {"domain.mapping=smooth", "domain.mapping_width=1e31"}),
              HasSubstr("allowed: up to 1e+30 either way"));
}

TEST(EndSettings, CutTheFilesWindowOff) {
  const Case whole = read_case(wash, {"time.end=10 s"});
  EXPECT_NEAR(whole.output.window_begin, 2 * std::numbers::pi, 1e-12);
  EXPECT_EQ(whole.output.window_end, 10);
  EXPECT_THAT(whole.notes,
              ElementsAre("cases/wash-3d/case.toml:38: output.window = [\"6.283185307179586 s\", "
                          "\"18.849555921538759 s\"]: cut off at \"10 s\", where --set time.end "
                          "ends the run"));
  EXPECT_THAT(read_case(wash).notes, IsEmpty());
  EXPECT_THAT(read_case(wash, {"time.end=20 s"}).notes, IsEmpty());
}

TEST(EndSettings, TakeTheWholeRunWhereItsWindowWouldBeLater) {
  const Case whole = read_case(wash, {"time.end=0.2 s"});
  EXPECT_EQ(whole.output.window_begin, 0);
  EXPECT_EQ(whole.output.window_end, 0.2);
  ASSERT_EQ(whole.notes.size(), 1u);
  EXPECT_THAT(whole.notes[0],
              HasSubstr("begins after \"0.2 s\", where --set time.end ends the run; "
                        "statistics are taken of the whole run"));
  const Case short_run = read_case(wash, {"time.end=1 ms"});
  EXPECT_EQ(short_run.output.every, 1e-3);
  EXPECT_THAT(short_run.notes.at(1), HasSubstr("longer than the run, taken as \"0.001 s\""));
}

TEST(EndSettings, DoNotExcuseWrongWindows) {
  EXPECT_THAT(error_when([] { read_case(wash, {"output.window=[\"1 s\", \"40 s\"]"}); }),
              HasSubstr("allowed: a begin before the end"));
  EXPECT_THAT(error_of(washer + "[output]\nwindow = [\"1 s\", \"5 s\"]\n"),
              HasSubstr("allowed: a begin before the end"));
}

TEST(Title, SaysWhatSetChanged) {
  EXPECT_EQ(read_case(wash).title, "16 pieces of cloth, Re 1200");
  EXPECT_EQ(read_case(wash, {"cloth.count=8", "fluid.viscosity=2 Pa s"}).title,
            "16 pieces of cloth, Re 1200 (changed: cloth.count=8, fluid.viscosity=2 Pa s)");
  EXPECT_EQ(read_case(wash, {"cloth.count=8", "title=half a load"}).title, "half a load");
  const Case changed = read_case(wash, {"cloth.count=8"});
  EXPECT_EQ(read_text(changed.resolved).title, changed.title);
  EXPECT_EQ(read_text(washer, {"domain.cells=16"}).title, "");
}

TEST(Defaults, AreNotBlamed) {
  EXPECT_THAT(error_when([] {
                read_case(wash, {"cloth.size=[\"20 cm\", \"15 cm\"]", "cloth.tilt=4 deg"});
              }),
              HasSubstr("--set cloth.size = [\"20 cm\", \"15 cm\"]: the cloth reaches beyond the "
                        "tub's wall from its inner_radius at \"0.148 m\" (default) on, allowed: up "
                        "to \"0.162 m\" that way; try a smaller cloth.inner_radius"));
  EXPECT_NO_THROW(
      read_case(wash, {"cloth.size=[\"20 cm\", \"15 cm\"]", "cloth.inner_radius=10 cm"}));
  EXPECT_THAT(error_when([] { read_case(wash, {"cloth.inner_radius=20 cm"}); }),
              HasSubstr("--set cloth.inner_radius = \"20 cm\": the cloth reaches beyond the tub's "
                        "wall, allowed: up to \"0.16 m\""));
  EXPECT_THAT(error_of(washer, {"washer.agitator.hub_radius=15 cm"}),
              HasSubstr("washer.agitator.hub_radius"));
  EXPECT_THAT(error_of(washer, {"washer.agitator.rim_radius=3 cm"}),
              HasSubstr("washer.agitator.skirt_top_radius = \"0.0"))
      << "names the default that does not go along";
  EXPECT_THAT(error_of(washer, {"washer.agitator.rim_radius=3 cm"}), HasSubstr("(default)"));
}

TEST(SpeedTables, AreToldToJump) {
  const Case jumps = read_text(washer + speeds + "speeds = [\"0 rpm\", \"90 rpm\", \"60 rpm\"]\n");
  ASSERT_EQ(jumps.notes.size(), 1u);
  EXPECT_THAT(jumps.notes[0],
              HasSubstr("solid \"agitator\": its speed jumps from 60 to 0 rpm every 2 s"));
  EXPECT_THAT(read_text(washer + speeds + "speeds = [\"5 rpm\", \"9 rpm\", \"5 rpm\"]\n").notes,
              IsEmpty());
  EXPECT_THAT(
      read_text(washer + speeds + "speeds = [\"0 rpm\", \"9 rpm\", \"5 rpm\"]\nrepeat = false\n")
          .notes,
      IsEmpty());
  EXPECT_THAT(read_text(washer).notes, IsEmpty());
}
