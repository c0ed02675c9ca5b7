#pragma once
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace washtub {

/// A formula of named variables as a case file gives it: "-6.13 * y", "r < 1 ? sin(pi x) : 0".
/// Besides the variables it knows `pi` and the usual functions. Not for use by several threads at
/// once.
class Expression {
 public:
  /// @throws InputError with the place of the mistake, and the variables and functions there are
  Expression(const std::string& text, const std::vector<std::string>& variables);
  ~Expression();
  Expression(Expression&&) noexcept;

  /// The value where the variables have these values, in the order of their names.
  double operator()(std::span<const double> values) const;

 private:
  struct Parser;
  std::unique_ptr<Parser> parser_;
};

}  // namespace washtub
