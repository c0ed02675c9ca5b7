#include "speed/results.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "io/file.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kind = "washtub bench";  // what such a file says it is

const Speed* find(const Speeds& speeds, const std::string& name) {
  const auto is = [&](const Speed& s) { return s.name == name; };
  const auto found = std::find_if(speeds.results.begin(), speeds.results.end(), is);
  return found == speeds.results.end() ? nullptr : &*found;
}

/// "1.23", or "-" for what does not apply.
std::string number(double value) { return value > 0 ? fmt::format("{:.3g}", value) : "-"; }

/// @throws any exception where something is missing or not as it should be
Speeds from_json(const Json& json) {
  if (json.at("kind") != kind) throw InputError("of another kind");
  Speeds speeds{json.at("commit"), json.at("processor"), json.at("ranks"), {}};
  for (const Json& r : json.at("results")) {
    speeds.results.push_back({r.at("name"), r.at("time [s]"), r.at("cells"), r.at("bytes")});
    if (!(speeds.results.back().seconds > 0)) throw InputError("without time");
  }
  return speeds;
}

}  // namespace

Json to_json(const Speeds& speeds) {
  Json results = Json::array();
  for (const Speed& s : speeds.results)
    results.push_back(
        {{"name", s.name}, {"time [s]", s.seconds}, {"cells", s.cells}, {"bytes", s.bytes}});
  return {{"kind", kind},
          {"commit", speeds.commit},
          {"processor", speeds.processor},
          {"ranks", speeds.ranks},
          {"results", results}};
}

Speeds read_speeds(const std::string& path) {
  const std::string text = read_file(path);
  try {
    return from_json(Json::parse(text));
  } catch (const std::exception&) {
    throw InputError(
        fmt::format("{}: no results of washtub bench; try a file that its -o wrote", path));
  }
}

std::string speed_table(const Speeds& now, const Speeds* before) {
  std::size_t width = 0;
  for (const Speed& s : now.results) width = std::max(width, s.name.size());
  std::string text = fmt::format("{:<{}}  {:>9}  {:>9}  {:>7}  {:>9}", "", width, "ms", "Mcells/s",
                                 "GB/s", "of triad");
  text += before ? fmt::format("  {:>9}\n", "speed-up") : "\n";
  const Speed* triad = find(now, "triad");
  for (const Speed& s : now.results) {
    const double share = triad ? 100 * s.byte_rate() / triad->byte_rate() : 0;
    text += fmt::format("{:<{}}  {:>9.4g}  {:>9}  {:>7}  {:>9}", s.name, width, 1e3 * s.seconds,
                        number(1e-6 * s.cell_rate()), number(1e-9 * s.byte_rate()),
                        share > 0 ? fmt::format("{:.0f} %", share) : "-");
    const Speed* then = before ? find(*before, s.name) : nullptr;
    if (before) text += fmt::format("  {:>9}", then ? number(then->seconds / s.seconds) : "-");
    text += "\n";
  }
  return text;
}

}  // namespace washtub
