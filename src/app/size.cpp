#include "app/size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <map>

#include "base/error.hpp"

namespace washtub {

std::size_t parse_size(const std::string& text) {
  const std::map<std::string, double> units = {
      {"", 1e6}, {"b", 1}, {"kb", 1e3}, {"mb", 1e6}, {"gb", 1e9}};
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  std::string unit;
  for (const char* c = end; *c != 0; ++c)
    if (*c != ' ') unit += static_cast<char>(std::tolower(static_cast<unsigned char>(*c)));
  const auto found = units.find(unit);
  const double bytes = found == units.end() ? 0 : number * found->second;
  if (end == text.c_str() || !(bytes >= 1) || bytes > 1e15)
    throw InputError(fmt::format(
        "--max-size \"{}\": expected a size such as \"20 MB\" or \"500 kB\", or a number of MB",
        text));
  return static_cast<std::size_t>(bytes);
}

}  // namespace washtub
