#include "program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

using testing::HasSubstr;
using washtub::testing::Outcome;
using washtub::testing::Program;
namespace fs = std::filesystem;

namespace {

std::string wash() { return fs::absolute("cases/wash-3d/case.toml").string(); }

/// The wash case with one key set.
std::string run_with(const std::string& setting) { return "run " + wash() + " --set " + setting; }

}  // namespace

TEST_F(Program, RefusesWrongKeysAndUnits) {
  refuses(run_with("cloth.strech_stiffness='8e5 N/m'"),
          "--set cloth.strech_stiffness = \"8e5 N/m\": unknown key, nearest known: "
          "cloth.stretch_stiffness");
  refuses(run_with("fluid.viscosity=1"),
          "--set fluid.viscosity = 1: expected dynamic viscosity with its unit such as \"1 Pa s\"");
  refuses(run_with("cloth.stretch_stiffness='8e5 N'"),
          "--set cloth.stretch_stiffness = \"8e5 N\": expected force per length such as "
          "\"8e5 N/m\"");
}

TEST_F(Program, RefusesImpossibleNumbers) {
  refuses(run_with("fluid.viscosity='-1 Pa s'"),
          "--set fluid.viscosity = \"-1 Pa s\": allowed: > 0 Pa s");
  refuses(run_with("domain.cells=0"), "--set domain.cells = 0: allowed: 8 to 8192");
  refuses(run_with("time.end='0 s'"), "--set time.end = \"0 s\": allowed: > 0 s");
  refuses(run_with("output.window='[\"1 s\", \"40 s\"]'"),
          "--set output.window = [\"1 s\", \"40 s\"]: allowed: a begin before the end, both from "
          "\"0 s\" to \"18.8496 s\" (time.end)");
}

TEST_F(Program, RefusesWhatDoesNotFit) {
  refuses(run_with("cloth.size='[\"40 cm\", \"15 cm\"]' --set cloth.folded=1"),
          "--set cloth.size = [\"40 cm\", \"15 cm\"]: the cloth is larger than the tub, whose "
          "radius and depth bound a page, allowed: below \"0.31 m\"; or folded (cloth.folded) as "
          "small as that");
  refuses(run_with("washer.agitator.fin_radius='32 cm'"),
          "--set washer.agitator.fin_radius = \"32 cm\": the agitator is wider than the tub, "
          "allowed: below 0.31 m (washer.radius)");
  refuses(run_with("washer.agitator.hub_height='22 cm'"),
          "--set washer.agitator.hub_height = \"22 cm\": the agitator is higher than the water, "
          "allowed: below 0.2004 m (washer.depth less the round cap)");
  refuses(run_with("domain.sides.x_lower=periodic"),
          "--set domain.sides.x_lower = \"periodic\": periodic sides come in pairs, so the "
          "opposite side must be periodic too");
}

TEST_F(Program, RefusesWrongCommandLines) {
  refuses("check nothing.toml", "nothing.toml: no such file");
  refuses("run " + wash() + " -n 0", "-n 0: allowed: 1 or more ranks");
  refuses("wash",
          "unknown command wash; there are run, check, modes, fabrics, bench, verify, report, "
          "compare, ensemble, movie, reference");
}

TEST_F(Program, DoesNotWriteOverTheCaseFile) {
  fs::create_directories(folder / "own");
  fs::copy_file(wash(), folder / "own" / "case.toml");
  const Outcome outcome = run("run own/case.toml -o own --force");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.text.find("is the folder of the case file"), std::string::npos);
  EXPECT_TRUE(fs::exists(folder / "own" / "case.toml"));
}

TEST_F(Program, KeepsResultsOfAnotherRun) {
  const fs::path results = folder / "out" / "wash-3d";
  fs::create_directories(results);
  std::ofstream(results / "history.csv") << "kept\n";
  const Outcome outcome = run("run " + wash());
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text,
            "washtub: out/wash-3d: holds files already; name another directory with -o, or "
            "overwrite results with --force\n");
  EXPECT_EQ(std::distance(fs::directory_iterator(results), {}), 1);
}

TEST_F(Program, RefusesAFileAsDirectory) {
  std::ofstream(folder / "file") << "kept\n";
  const Outcome outcome = run("run " + wash() + " -o file");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_EQ(outcome.text, "washtub: file: is not a directory; name another one with -o\n");
}

TEST_F(Program, EveryCaseOfTheProjectIsValid) {
  for (const auto& entry : fs::recursive_directory_iterator("cases")) {
    if (entry.path().extension() != ".toml") continue;
    const Outcome outcome = run("check --no-forecast " + fs::absolute(entry.path()).string());
    EXPECT_EQ(outcome.code, 0) << outcome.text;
  }
}

TEST_F(Program, CheckForeseesWhatTheGridCannotResolve) {
  EXPECT_THAT(run("check --no-forecast " + wash() + " --set 'fluid.viscosity=1e-3 Pa s'").text,
              HasSubstr("warning      the grid will hardly resolve this flow: at 3.9 m/s"));
  EXPECT_THAT(run("check --no-forecast " + wash()).text, testing::Not(HasSubstr("hardly resolve")));
}

/// On one rank and on several; what the case means is told once.
TEST_F(Program, CheckForeseesTheRun) {
  const std::string small = " --set domain.cells=16 --set cloth.count=0 --set time.end='1 s'";
  for (const std::string ranks : {"1", "2"}) {
    const Outcome outcome = run("check " + wash() + small + " -n " + ranks);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    const auto forecast = outcome.text.find("\nforecast     about 2");
    ASSERT_NE(forecast, std::string::npos) << outcome.text;
    EXPECT_THAT(outcome.text, HasSubstr(ranks == "1" ? " on one rank" : " on 2 ranks"));
    EXPECT_THAT(outcome.text.substr(forecast), HasSubstr("\nmemory       about "));
    EXPECT_THAT(outcome.text.substr(forecast), HasSubstr("\ndisk         about "));
    EXPECT_EQ(outcome.text.find("case  "), outcome.text.rfind("case  "));
  }
  refuses("check " + wash() + " -n 0", "-n 0: allowed: 1 or more ranks");
}

TEST_F(Program, BenchComparesWithEarlierResults) {
  refuses("bench --compare " + wash(),
          wash() + ": no results of washtub bench; try a file that its -o wrote");
  refuses("bench -o " + wash(),
          wash() + ": exists and is no file of washtub bench; name another file with -o");
  refuses("bench --filter nothing", "--filter: nothing has such a name");
  const Outcome first = run("bench --filter triad -o speeds.json");
  EXPECT_EQ(first.code, 0) << first.text;
  EXPECT_THAT(first.text, HasSubstr("\ntriad "));
  EXPECT_THAT(first.text, HasSubstr("100 %"));
  const Outcome second = run("bench --filter triad -n 2 -o speeds.json --compare speeds.json");
  EXPECT_EQ(second.code, 0) << second.text;
  EXPECT_THAT(second.text, HasSubstr("speed-up"));
  EXPECT_THAT(second.text, HasSubstr("2 ranks\nagainst commit "));
}

TEST_F(Program, CheckPrintsThePapersGroups) {
  const std::string text = run("check --no-forecast " + wash()).text;
  for (const char* part : {"32 x 32 x 32 cells", "Re = 1208", "Te = 170", "Be = 2.2", "Se = 0.0638",
                           "To = 2.2", "In = 0.0003", "St = 0.0507", "16 pieces"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(Program, PagesOfTheDocumentsAreCurrent) {
  const auto expect = [&](const std::string& name, const std::string& command) {
    std::ifstream file("docs/" + name);
    const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
    EXPECT_EQ(page, run(command).text)
        << "write it anew with: ./washtub " << command << " > docs/" << name;
  };
  expect("input.md", "reference");
  expect("output.md", "reference --output");
}

TEST_F(Program, CheckKeepsItsColumnsApart) {
  const std::string group =
      "[[cloth]]\nsize = [\"10 cm\", \"10 cm\"]\nbending_stiffness = \"1e-5 N m\"\n"
      "thickness = \"1 mm\"\nstretch_stiffness = ";
  std::ofstream(folder / "two.toml")
      << "[washer]\nradius = \"31 cm\"\ndepth = \"24 cm\"\n[fluid]\nviscosity = \"1 Pa s\"\n"
         "[domain]\ncells = 32\n[time]\nend = \"1 s\"\n"
      << group << "\"8e5 N/m\"\n"
      << group << "\"8e-5 N/m\"\n";
  const std::string text = run("check --no-forecast two.toml").text;
  EXPECT_THAT(text, HasSubstr("Te of cloth 1 = 170  stretch stiffness"));
  EXPECT_THAT(text, HasSubstr("Te of cloth 2 = 1.7e-08  stretch stiffness"));
}

TEST_F(Program, CheckAndRunTellNotes) {
  const std::string note = wash() + ":38: output.window = ";
  EXPECT_THAT(run("check --no-forecast " + wash() + " --set time.end='0.2 s'").text,
              HasSubstr("\nnote         " + note));
  const std::string shorter = " --set time.end='1 ms' --set domain.cells=16 --set cloth.count=0";
  for (const std::string ranks : {"1", "2"}) {
    const Outcome outcome = run("run " + wash() + shorter + " --force --no-report -n " + ranks);
    EXPECT_EQ(outcome.code, 0) << outcome.text;
    const auto told = outcome.text.find("note: " + note);
    ASSERT_NE(told, std::string::npos) << outcome.text;
    EXPECT_EQ(outcome.text.find("note: " + note, told + 1), std::string::npos) << "told twice";
    std::ifstream log(folder / "out" / "wash-3d" / "log.txt");
    EXPECT_THAT(std::string(std::istreambuf_iterator<char>(log), {}), HasSubstr("note: " + note));
  }
}
