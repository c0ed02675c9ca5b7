#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/commands.hpp"
#include "app/protect.hpp"
#include "case/case.hpp"
#include "cloth/modes.hpp"
#include "io/file.hpp"
#include "washer/build.hpp"

namespace washtub {
namespace {

/// Frequencies of a group in vacuo, its mass that beyond the displaced water [Hz].
template <int D>
std::vector<double> frequencies(const ClothGroup<D>& group, int count) {
  const Sheet<D>& sheet = group.sheet;
  return natural_frequencies(sheet, group.pinned, sheet.material.excess_mass, count);
}

template <int D>
void print_group(std::size_t number, const ClothGroup<D>& group,
                 const std::vector<double>& frequencies) {
  fmt::print("cloth {}: {} nodes, {} pinned, {:.6g} kg/m^2 (excess mass, no water)\n", number,
             group.sheet.nodes(), group.pinned.size(), group.sheet.material.excess_mass);
  for (std::size_t m = 0; m < frequencies.size(); ++m)
    fmt::print("  mode {:<3} {:.6g} Hz\n", m + 1, frequencies[m]);
}

/// Prints all groups' frequencies and returns them, group after group [Hz].
template <int D>
std::vector<double> print_modes(const Case& whole, int count) {
  std::vector<double> all;
  const Cloth<D> cloth = build_cloth<D>(whole);
  for (std::size_t g = 0; g < cloth.groups.size(); ++g) {
    const auto own = frequencies(cloth.groups[g], count);
    print_group(g + 1, cloth.groups[g], own);
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

}  // namespace

int command_modes(const ModesArguments& arguments) {
  const Case whole = read_case(arguments.input.path, arguments.input.settings);
  const auto all = whole.dimension == 3 ? print_modes<3>(whole, arguments.count)
                                        : print_modes<2>(whole, arguments.count);
  if (all.empty()) fmt::print("no cloth that vibrates\n");
  if (arguments.file.empty()) return 0;
  protect_modes(arguments.file);
  const nlohmann::ordered_json out = {{"frequencies [Hz]", all}};
  replace_file(arguments.file, out.dump(2) + "\n");
  return 0;
}

}  // namespace washtub
