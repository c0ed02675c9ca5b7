#include "base/expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <muParser.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.hpp"

namespace washtub {
namespace {

const std::vector<std::string> functions = {"sin",  "cos",  "tan",   "asin", "acos", "atan",
                                            "sinh", "cosh", "tanh",  "exp",  "ln",   "log10",
                                            "sqrt", "abs",  "atan2", "min",  "max",  "erf"};

[[noreturn]] void refuse(std::size_t position, const std::string& reason,
                         const std::vector<std::string>& variables) {
  throw InputError(fmt::format(
      "mistake in the formula at letter {}: {}; variables: {}; constant: pi; functions: {}; "
      "operators: + - * / ^ and a < b ? c : d",
      position + 1, reason, fmt::join(variables, ", "), fmt::join(functions, ", ")));
}

/// Position of an `=` that is not part of a comparison; npos where there is none.
std::size_t assignment(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '=') continue;
    if (i + 1 < text.size() && text[i + 1] == '=')
      ++i;
    else if (i == 0 || std::string("<>!").find(text[i - 1]) == std::string::npos)
      return i;
  }
  return std::string::npos;
}

}  // namespace

struct Expression::Parser {
  mu::Parser formula;
  std::vector<double> values;
};

Expression::Expression(const std::string& text, const std::vector<std::string>& variables)
    : parser_(std::make_unique<Parser>()) {
  if (text.find_first_not_of(" \t\n") == std::string::npos) refuse(0, "it is empty", variables);
  if (const auto at = assignment(text); at != std::string::npos)
    refuse(at, "\"=\" assigns nothing; \"==\" compares", variables);
  parser_->values.resize(variables.size());
  try {
    mu::Parser& formula = parser_->formula;
    formula.DefineConst("pi", std::numbers::pi);
    formula.DefineFun("erf", static_cast<double (*)(double)>(std::erf));
    for (std::size_t i = 0; i < variables.size(); ++i)
      formula.DefineVar(variables[i], &parser_->values[i]);
    formula.SetExpr(text);
    int results = 0;
    formula.Eval(results);
    if (results != 1) refuse(text.find(','), "one value is expected, not several", variables);
  } catch (const mu::ParserError& error) {
    const auto end = text.find_last_not_of(" \t\n") + 1;
    const auto at = std::min(static_cast<std::size_t>(std::max(error.GetPos(), 0)), end);
    std::string token = error.GetToken();
    while (!token.empty() && token.back() == ' ') token.pop_back();
    refuse(at,
           token.empty() || at == end ? "it ends too early" : "\"" + token + "\" is not understood",
           variables);
  }
}

Expression::~Expression() = default;
Expression::Expression(Expression&&) noexcept = default;

double Expression::operator()(std::span<const double> values) const {
  std::copy(values.begin(), values.end(), parser_->values.begin());
  return parser_->formula.Eval();
}

}  // namespace washtub
