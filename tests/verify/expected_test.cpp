#include "verify/expected.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "verify/folder.hpp"

namespace washtub {
namespace {

using testing::Folder;
using ::testing::HasSubstr;

constexpr const char* good = R"(title = "A case"
[[run]]
name = "coarse"
[[run]]
name = "fine"
level = "full"
set = ["domain.cells=64"]
[[quantity]]
name = "error"
run = "coarse"
column = "speed"
take = "max"
window = ["1 s", "2 s"]
at_most = 0.1
source = "exact"
[[quantity]]
name = "order"
runs = ["coarse", "fine"]
column = "speed"
take = "last"
at_least = 1.8
source = "exact"
[[figure]]
name = "speed"
[[figure.curve]]
label = "coarse"
run = "coarse"
column = "speed"
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// What reading an expected.toml says.
std::string error_of(const std::string& text) {
  const Folder folder;
  folder.write("case.toml", "");
  folder.write("expected.toml", text);
  try {
    read_expected(folder.path(""));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(ExpectedFile, IsRead) {
  const Folder folder;
  folder.write("deck/case.toml", "");
  folder.write("deck/expected.toml", good);
  const Expected e = read_expected(folder.path("deck/"));
  EXPECT_EQ(e.name, "deck");
  ASSERT_EQ(e.runs.size(), 2U);
  EXPECT_EQ(e.runs[1].settings, std::vector<std::string>{"domain.cells=64"});
  EXPECT_EQ(e.quantities[0].window[1], 2);
  EXPECT_EQ(e.level_of(e.quantities[0]), VerifyLevel::quick);
  EXPECT_EQ(e.level_of(e.quantities[1]), VerifyLevel::full);
  EXPECT_EQ(e.figures[0].curves[0].run, "coarse");
  EXPECT_EQ(case_names(folder.path("")), std::vector<std::string>{"deck"});
}

TEST(ExpectedFile, ErrorsNameLineKeyAndNearest) {
  EXPECT_EQ(error_of(good), "");
  const auto says = [](const std::string& from, const std::string& to, const std::string& error) {
    EXPECT_THAT(error_of(replaced(good, from, to)), HasSubstr(error));
  };
  says("at_most", "at_moost",
       "expected.toml:14: quantity[1].at_moost = 0.1: unknown key, nearest known: "
       "quantity.at_most");
  says("\"max\"", "\"maximum\"",
       "expected.toml:12: quantity[1].take = \"maximum\": expected one of");
  says("\"1 s\"", "1", "quantity[1].window");
  says("run = \"coarse\"", "run = \"course\"",
       "expected.toml:10: quantity[1].run = \"course\": no run \"course\", nearest: \"coarse\"");
  says("name = \"fine\"", "name = \"coarse\"", "the name is taken");
  says("name = \"fine\"", "name = \"../fine\"", "allowed: letters, digits");
  says("at_most = 0.1", "value = 0.1", "one of the keys tolerance, tolerance_percent, found none");
  says("at_most = 0.1", "", "one of the keys value, at_least, at_most, found none");
  says("source = \"exact\"", "", "missing key quantity[1].source");
  says("take = \"max\"", "", "missing key take");
  says("[\"coarse\", \"fine\"]", "[\"coarse\"]", "an order needs two or three runs");
  says("level = \"full\"", "case = \"none.toml\"", "no such case file");
}

TEST(ExpectedFile, KeysOfTheDocumentAreCurrent) {
  std::string keys;
  expected_table().document(keys, "");
  std::ifstream file("docs/verification.md");
  const std::string page{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  EXPECT_THAT(page, HasSubstr(keys)) << "put these tables in docs/verification.md:\n" << keys;
}

TEST(ExpectedFile, EveryCaseOfTheProjectIsValid) {
  for (const auto& name : case_names("verification"))
    EXPECT_NO_THROW(read_expected("verification/" + name)) << name;
}

}  // namespace
}  // namespace washtub
