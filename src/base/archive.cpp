#include "base/archive.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace washtub {

void Archive::wrong_length(const std::string& path, std::size_t archived, std::size_t here) {
  throw InputError(fmt::format("{}: {} values there, {} in this case", path, archived, here));
}

}  // namespace washtub
