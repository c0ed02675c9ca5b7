#include <fmt/format.h>

#include "app/commands.hpp"
#include "case/case.hpp"

namespace washtub {

int command_reference() {
  fmt::print("{}", input_reference());
  return 0;
}

}  // namespace washtub
