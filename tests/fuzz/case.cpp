#include "case/case.hpp"

#include "base/settings.hpp"
#include "case/description.hpp"
#include "case/groups.hpp"
#include "input.hpp"

using namespace washtub;

namespace {

/// A line "--set KEY=VALUE" is such an argument, all others are the case file's.
Case read(std::string_view input) {
  std::string text;
  std::vector<std::string> settings;
  fuzz::for_lines(input, [&](std::string_view line) {
    if (line.starts_with("--set "))
      settings.emplace_back(line.substr(6));
    else
      text.append(line).append(1, '\n');
  });
  return read_case_text(text, "case.toml", settings);
}

}  // namespace

/// A case that is taken can be described, and read again from what it writes of itself.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Case whole;
  if (!fuzz::takes([&] { whole = read(fuzz::text_of(data, size)); })) return 0;
  describe(whole);
  groups(whole);
  settings_of(parse_text(whole.resolved, "resolved"));
  const Case again = read_case_text(whole.resolved, "resolved");
  if (again.resolved != whole.resolved) throw std::logic_error(whole.resolved + again.resolved);
  return 0;
}
