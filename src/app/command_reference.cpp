#include <fmt/format.h>

#include "app/commands.hpp"
#include "case/case.hpp"
#include "record/reference.hpp"

namespace washtub {

int command_reference(const ReferenceArguments& arguments) {
  fmt::print("{}", arguments.schema   ? case_schema()
                   : arguments.output ? output_reference()
                                      : input_reference());
  return 0;
}

}  // namespace washtub
