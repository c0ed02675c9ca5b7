#pragma once
#include <stdexcept>
#include <string>

namespace washtub {

/// The user asked for something impossible; the text says what, where, what is allowed, what to
/// try. The program prints it and exits with code 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The simulation cannot go on (NaN, over-stretched cloth, failed solve, full disk); exit code 1.
class RunError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace washtub
