#include "ensemble/members.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <numeric>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr std::uint64_t most = 10000;  // members

/// Whether the start of a group of cloth draws random numbers.
bool is_drawn(const ClothCase& cloth) {
  return cloth.count > 0 && cloth.arrangement != Arrangement::sheet &&
         cloth.arrangement != Arrangement::ring;
}

/// A whole number and nothing else, from 1 on; 0 where there is none.
std::uint64_t whole_number(std::string_view text) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
  return error == std::errc() && end == text.end() ? value : 0;
}

}  // namespace

std::vector<std::uint64_t> parse_seeds(const std::string& text) {
  const auto dash = text.find('-');
  const bool range = dash != std::string::npos;
  const std::uint64_t first = range ? whole_number(text.substr(0, dash)) : 1;
  const std::uint64_t last = whole_number(range ? text.substr(dash + 1) : text);
  if (first < 1 || last < 1 || last <= first || last - first >= most)
    throw InputError(
        fmt::format("--seeds {}: should be how many, 2 to {}, as in 5, or the first and the last, "
                    "as in 6-10",
                    text, most));
  std::vector<std::uint64_t> seeds(last - first + 1);
  std::iota(seeds.begin(), seeds.end(), first);
  return seeds;
}

std::vector<std::string> member_settings(const Case& whole, std::uint64_t seed) {
  if (std::none_of(whole.cloth.begin(), whole.cloth.end(), is_drawn))
    throw InputError(
        "nothing in this case is drawn at random, so that runs with other seeds are the same; an "
        "ensemble needs cloth whose arrangement is neither \"sheet\" nor \"ring\"");
  const auto [least, largest] =
      std::minmax_element(whole.cloth.begin(), whole.cloth.end(),
                          [](const ClothCase& a, const ClothCase& b) { return a.seed < b.seed; });
  const std::uint64_t shift = (seed - 1) * (largest->seed - least->seed + 1);
  std::vector<std::string> settings;
  for (std::size_t g = 0; g < whole.cloth.size(); ++g)
    settings.push_back(fmt::format("cloth[{}].seed={}", g + 1, whole.cloth[g].seed + shift));
  return settings;
}

std::string member_name(std::uint64_t seed) { return fmt::format("seed-{}", seed); }

}  // namespace washtub
