#include <fmt/format.h>

#include <algorithm>

#include "app/commands.hpp"
#include "base/nearest.hpp"
#include "case/fabrics.hpp"

namespace washtub {

int command_fabrics(const std::string& name) {
  if (name.empty()) {
    fmt::print(
        "{}\nwashtub fabrics NAME shows all values of one and their sources; fabric = "
        "\"NAME\" in [[cloth]] takes them.\n",
        fabric_reference());
    return 0;
  }
  const auto found = std::find_if(fabrics().begin(), fabrics().end(),
                                  [&](const Fabric& fabric) { return fabric.name == name; });
  if (found == fabrics().end()) {
    const std::string nearest = nearest_name(name, fabric_names());
    throw InputError(fmt::format("no fabric \"{}\"{}; washtub fabrics lists them", name,
                                 nearest.empty() ? "" : ", nearest: \"" + nearest + "\""));
  }
  fmt::print("{}", fabric_text(*found));
  return 0;
}

}  // namespace washtub
