#include "base/document.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace washtub {
namespace {

using ::testing::HasSubstr;
using ::testing::StrEq;
using ::testing::ThrowsMessage;

std::string repeated(const std::string& part, int times) {
  std::string text;
  for (int i = 0; i < times; ++i) text += part;
  return text;
}

const char* const too_deep =
    ": tables and lists lie in each other more than 64 deep; no case needs that";

TEST(Document, DepthIsBounded) {
  const auto file = [](const std::string& text) {
    return [=] { parse_text("x = 1\n" + text, "a.toml"); };
  };
  const auto refused = ThrowsMessage<InputError>(StrEq(std::string("a.toml:2") + too_deep));
  EXPECT_THAT(file(repeated("a.", 100000) + "a = 1"), refused);
  EXPECT_THAT(file("[" + repeated("a.", 100000) + "a]"), refused);
  EXPECT_THAT(file("a = " + repeated("[", 70) + repeated("]", 70)), refused);
  EXPECT_THAT(file(repeated("a.", 40) + "a = " + repeated("{ a = ", 40) + "1" + repeated("}", 40)),
              refused);
  EXPECT_NO_THROW(file("a = [" + repeated("0.5, ", 100) + "0.5]")());
  EXPECT_NO_THROW(file("a = \"" + repeated(".", 100) + "\"  # " + repeated(".", 100))());
  EXPECT_NO_THROW(file(repeated("a.", 30) + "a = " + repeated("[", 30) + repeated("]", 30))());
}

TEST(Document, DepthOfSettingsIsBounded) {
  const auto set = [](const std::string& setting) {
    return [=] {
      Node root = parse_text("", "a.toml");
      apply_setting(root, setting);
    };
  };
  const auto refused = ThrowsMessage<InputError>(HasSubstr(too_deep));
  EXPECT_THAT(set(repeated("a.", 100000) + "a=1"), refused);
  EXPECT_THAT(set("a={" + repeated("a.", 100000) + "a=1}"), refused);
}

TEST(Document, AQuotedNameIsNoPath) {
  const Node root = parse_text("\"time.end\" = 1\n[\"cloth[1]\"]\nplain-name = 2\n", "a.toml");
  EXPECT_EQ(root.members()[0].node.key, "\"time.end\"");
  EXPECT_EQ(root.members()[1].node.members()[0].node.key, "\"cloth[1]\".plain-name");
}

TEST(Document, AnyTextReadsBack) {
  const std::string text = "a\tb\r\n\x01\x7f \"quoted\" \\ \u00e4";
  const auto node = parse_value(quoted(text), "title");
  ASSERT_TRUE(node);
  EXPECT_EQ(std::get<std::string>(node->value), text);
}

TEST(Document, SettingsAreUtf8) {
  Node root = parse_text("", "a.toml");
  EXPECT_THAT([&] { apply_setting(root, "title=caf\xe9"); },
              ThrowsMessage<InputError>(HasSubstr(": the value is no text in UTF-8")));
  apply_setting(root, "title=caf\u00e9\r");
  EXPECT_EQ(std::get<std::string>(root.find("title")->value), "caf\u00e9\r");
}

}  // namespace
}  // namespace washtub
