#pragma once
#include <string>

namespace washtub {

/// What the files of a run hold, in Markdown, from the declarations of their columns and entries.
std::string output_reference();

}  // namespace washtub
