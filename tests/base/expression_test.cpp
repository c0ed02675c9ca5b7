#include "base/expression.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/format.hpp"

using namespace washtub;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

namespace {

double value(const std::string& text, double x, double y) {
  return Expression(text, {"x", "y"})(std::array{x, y});
}

std::string error_of(const std::string& text) {
  try {
    const Expression formula(text, {"x", "y"});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

}  // namespace

TEST(Expression, ComputesWithItsVariables) {
  EXPECT_DOUBLE_EQ(value("-6.13 * y + x^2", 3, 2), 9 - 12.26);
  EXPECT_DOUBLE_EQ(value("sin(pi/6)", 0, 0), 0.5);
  EXPECT_DOUBLE_EQ(value("x < 1 ? 10 : 20", 0.5, 0), 10);
  EXPECT_DOUBLE_EQ(value("x < 1 ? 10 : 20", 1.5, 0), 20);
  EXPECT_DOUBLE_EQ(value("x >= 1 && y == 2", 1, 2), 1);
  EXPECT_DOUBLE_EQ(value("atan2(y, x) + max(x, y) + erf(x)", 1, 1),
                   std::atan2(1, 1) + 1 + std::erf(1));
}

TEST(Expression, MayBeMoved) {
  std::vector<Expression> formulas;
  for (const char* text : {"x", "2*x", "3*x"})
    formulas.emplace_back(text, std::vector<std::string>{"x"});
  EXPECT_DOUBLE_EQ(formulas[0](std::array{5.0}) + formulas[2](std::array{7.0}), 26);
}

TEST(Expression, ErrorsNamePlaceAndWhatThereIs) {
  EXPECT_THAT(error_of("2 * u + 1"),
              AllOf(StartsWith("mistake in the formula at letter 5: \"u\" is not understood"),
                    HasSubstr("variables: x, y;"), HasSubstr("functions: sin, cos,")));
  EXPECT_THAT(error_of("sin(x"), HasSubstr("at letter 6: it ends too early"));
  EXPECT_THAT(error_of("x = 3"), HasSubstr("at letter 3: \"=\" assigns nothing"));
  EXPECT_THAT(error_of("1, 2"), HasSubstr("at letter 2: one value is expected"));
  EXPECT_THAT(error_of(" "), HasSubstr("it is empty"));
}

TEST(Formulas, TakeQuantitiesToo) {
  const auto format = formulas(measure::speed, false);
  const auto entry = [](const char* text) { return Node{std::string(text), "wash.toml:3", "u"}; };
  const Node node{Node::List{entry("20 cm/s"), entry("2 * r")}, "wash.toml:3", "u"};
  EXPECT_EQ(format.read(node, 2), (std::array<std::string, 3>{"0.2", "2 * r", "0"}));
  const Node late{Node::List{entry("t"), entry("0")}, "wash.toml:3", "u"};
  EXPECT_THROW(format.read(late, 2), InputError);
  EXPECT_EQ(formulas(measure::speed, true).read(late, 2)[0], "t");
  const Node bare{Node::List{Node{1.5, "wash.toml:3", "u"}, entry("0")}, "wash.toml:3", "u"};
  EXPECT_THROW(format.read(bare, 2), InputError);
}
