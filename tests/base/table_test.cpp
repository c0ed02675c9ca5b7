#include "base/table.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>

#include "base/kinds.hpp"

using namespace washtub;

namespace {

enum class Weave { plain, twill };

struct Cloth {
  double stiffness = 8e5;
  int count = 1;
  Weave weave = Weave::plain;
  Vec<3> centre = Vec<3>::Zero();
};

struct Input {
  std::vector<Cloth> cloth;
};

Table<Cloth> cloth_table() {
  Table<Cloth> table("Cloth.");
  table.key("stretch_stiffness", &Cloth::stiffness, quantity(measure::stiffness, above(0)), "K_e")
      .key("count", &Cloth::count, integer(between(0, 100)), "pieces")
      .required()
      .key("weave", &Cloth::weave,
           choice<Weave>({{"plain", Weave::plain}, {"twill", Weave::twill}}), "weave")
      .key("centre", &Cloth::centre, vector(measure::length), "place")
      .only("for \"twill\"", [](const Cloth& cloth, int) { return cloth.weave == Weave::twill; });
  return table;
}

Table<Input> input_table() {
  Table<Input> table("Input.");
  table.list("cloth", &Input::cloth, cloth_table(), [](const Input&) { return Cloth(); });
  return table;
}

/// Reads TOML text in two dimensions through a file called wash.toml.
Input read(const std::string& text, const std::vector<std::string>& settings = {}) {
  char folder[] = "/tmp/washtub-test-XXXXXX";
  EXPECT_NE(mkdtemp(folder), nullptr);
  EXPECT_EQ(chdir(folder), 0);
  std::ofstream("wash.toml") << text;
  struct Cleaner {
    const char* folder;
    ~Cleaner() {
      std::remove("wash.toml");
      rmdir(folder);
    }
  } cleaner{folder};
  Node root = parse_file("wash.toml");
  for (const std::string& setting : settings) apply_setting(root, setting);
  const Table<Input> table = input_table();
  check_known(root, table.names());
  Input input;
  table.read(input, root, 2);
  return input;
}

std::string error_of(const std::string& text, const std::vector<std::string>& settings = {}) {
  try {
    read(text, settings);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

const std::string good = "[cloth]\ncount = 3\n";

}  // namespace

TEST(Schema, ErrorsNamePlaceKeyAndExpectation) {
  EXPECT_EQ(error_of(good + "stretch_stiffness = \"8e5 N\""),
            "wash.toml:3: cloth.stretch_stiffness = \"8e5 N\": expected force per length such as "
            "\"8e5 N/m\"");
  EXPECT_EQ(error_of(good + "stretch_stiffness = 8e5"),
            "wash.toml:3: cloth.stretch_stiffness = 800000.0: expected force per length with its "
            "unit such as \"8e5 N/m\"");
  EXPECT_EQ(error_of(good + "strech_stiffness = \"8e5 N/m\""),
            "wash.toml:3: cloth.strech_stiffness = \"8e5 N/m\": unknown key, nearest known: "
            "cloth.stretch_stiffness");
  EXPECT_EQ(error_of(good + "stretch_stiffness = \"-1 N/m\""),
            "wash.toml:3: cloth.stretch_stiffness = \"-1 N/m\": allowed: > 0 N/m");
}

TEST(Schema, ErrorsOfOtherKinds) {
  EXPECT_EQ(error_of("[cloth]\ncount = 101"), "wash.toml:2: cloth.count = 101: allowed: 0 to 100");
  EXPECT_EQ(error_of("[cloth]\ncount = 1.5"),
            "wash.toml:2: cloth.count = 1.5: expected an integer such as 16");
  EXPECT_EQ(error_of("[cloth]"), "wash.toml:1: missing key cloth.count: integer, pieces");
  EXPECT_EQ(error_of("cloth = 3"), "wash.toml:1: cloth = 3: expected a table");
  EXPECT_EQ(error_of(good + "weave = \"twil\""),
            "wash.toml:3: cloth.weave = \"twil\": expected one of \"plain\", \"twill\", nearest: "
            "\"twill\"");
  EXPECT_EQ(error_of(good + "centre = [\"1 m\", \"2 m\"]"),
            "wash.toml:3: cloth.centre = [\"1 m\", \"2 m\"]: only for \"twill\"; --set "
            "cloth.centre= takes it out");
  EXPECT_EQ(error_of(good + "weave = \"twill\"\ncentre = [\"1 m\"]"),
            "wash.toml:4: cloth.centre = [\"1 m\"]: expected a list of 2 quantities such as "
            "\"15 cm\"");
}

TEST(Schema, BrokenTomlGivesTheLine) {
  EXPECT_EQ(error_of(good + "weave = ").rfind("wash.toml:3: ", 0), 0u);
  EXPECT_THROW(parse_file("no-such-file.toml"), InputError);
}

TEST(Schema, SettingsReplaceAddAndReportThemselves) {
  EXPECT_EQ(read(good, {"cloth.count=32"}).cloth.at(0).count, 32);
  EXPECT_EQ(read("", {"cloth.count=5"}).cloth.at(0).count, 5);
  EXPECT_DOUBLE_EQ(read(good, {"cloth.stretch_stiffness=2 kN/m"}).cloth.at(0).stiffness, 2000);
  EXPECT_EQ(error_of(good, {"cloth.stretch_stiffness=8e5 N"}),
            "--set cloth.stretch_stiffness = \"8e5 N\": expected force per length such as "
            "\"8e5 N/m\"");
  EXPECT_EQ(error_of(good, {"cloth.count"}),
            "--set cloth.count: expected key=value such as cloth.count=32");
}

TEST(Schema, SettingsAddressEntriesOfLists) {
  const std::string two = "[[cloth]]\ncount = 1\n[[cloth]]\ncount = 2\n";
  EXPECT_EQ(read("[[cloth]]\ncount = 1\n", {"cloth.count=7"}).cloth.at(0).count, 7);
  const Input input = read(two, {"cloth[2].count=9"});
  EXPECT_EQ(input.cloth.at(0).count, 1);
  EXPECT_EQ(input.cloth.at(1).count, 9);
  EXPECT_EQ(error_of(two, {"cloth.count=9"}),
            "--set cloth.count=9: there are 2 of cloth, name one of cloth[1] to cloth[2]");
  EXPECT_EQ(error_of(two, {"cloth[2].count=-1"}), "--set cloth[2].count = -1: allowed: 0 to 100");
}

TEST(Schema, SettingsNameEntriesThatExist) {
  const std::string one = "[[cloth]]\ncount = 1\n";
  EXPECT_EQ(read(one, {"cloth[1].count=7"}).cloth.at(0).count, 7);
  EXPECT_EQ(read(good, {"cloth[1].count=7"}).cloth.at(0).count, 7);
  for (const std::string entry : {"[0]", "[x]", "[1", "[]", "[-1]", "[1]x"})
    EXPECT_EQ(error_of(one, {"cloth" + entry + ".count=7"}),
              "--set cloth" + entry + ".count=7: cloth" + entry +
                  ": expected a number from 1 between the brackets, as in cloth[1]");
  for (const std::string& text : {one, good})
    EXPECT_EQ(error_of(text, {"cloth[2].count=7"}),
              "--set cloth[2].count=7: there is one cloth, name it as cloth or cloth[1]");
}

TEST(Schema, SettingsReachIntoLists) {
  const std::string placed = good + "weave = \"twill\"\ncentre = [\"1 m\", \"2 m\"]\n";
  EXPECT_EQ(read(placed, {"cloth.centre[2]=3 m"}).cloth.at(0).centre, Vec<3>(1, 3, 0));
  EXPECT_EQ(error_of(placed, {"cloth.centre[3]=3 m"}),
            "--set cloth.centre[3]=3 m: there are 2 of centre, name one of centre[1] to centre[2]");
  EXPECT_EQ(error_of(placed, {"cloth.count[1]=3"}),
            "--set cloth.count[1]=3: count is no list in the case file");
}

TEST(Schema, SettingsTakeOut) {
  const std::string two = "[[cloth]]\ncount = 1\n[[cloth]]\ncount = 2\n";
  EXPECT_EQ(read(two, {"cloth[1]="}).cloth.at(0).count, 2);
  EXPECT_EQ(error_of(good, {"cloth.count="}),
            "wash.toml:1: missing key cloth.count: integer, pieces");
  EXPECT_EQ(error_of(good, {"cloth.weave="}),
            "--set cloth.weave=: the case file does not give it, so it cannot be taken out");
}

TEST(Schema, WrittenTextHoldsEveryKeyThatApplies) {
  std::string out;
  input_table().write(out, read(good), "", 2);
  EXPECT_EQ(out, "\n[[cloth]]\nstretch_stiffness = \"800000 N/m\"\ncount = 3\nweave = \"plain\"\n");
}

TEST(Schema, ReferenceShowsDefaultRangeAndMeaning) {
  std::string out;
  input_table().document(out, "");
  EXPECT_NE(out.find("| `stretch_stiffness` | force per length [N/m] | `\"800000 N/m\"` | > 0 N/m "
                     "| K_e |"),
            std::string::npos);
  EXPECT_NE(out.find("| `count` | integer | required | 0 to 100 | pieces |"), std::string::npos);
}
