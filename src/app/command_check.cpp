#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "app/commands.hpp"
#include "case/case.hpp"
#include "case/description.hpp"
#include "case/groups.hpp"
#include "washer/build.hpp"
#include "washer/resolution.hpp"

namespace washtub {
namespace {

/// Measured on washes of 32 to 96 cells an axis in 3-D and up to 512 in 2-D: what a cell takes in
/// fields, masks, multigrid levels and the state to go back to, and the program with its libraries.
constexpr double bytes_per_cell = 600, program_bytes = 70e6;

/// Text at a column, or two spaces further on where what stands before it reaches there.
std::string columns(const std::string& name, std::size_t column, const std::string& text) {
  return fmt::format("{:<{}}{}", name, std::max(column, name.size() + 2), text);
}

void print_line(const std::string& name, const std::string& text) {
  fmt::print("{}\n", columns(name, 13, text));
}

double cell_count(const Case& whole) {
  double cells = 1;
  for (int axis = 0; axis < whole.dimension; ++axis)
    cells *= whole.domain.cells[static_cast<std::size_t>(axis)];
  return cells;
}

void print_memory(const Case& whole) {
  print_line("memory", fmt::format("about {:.0f} MB on one rank",
                                   (cell_count(whole) * bytes_per_cell + program_bytes) / 1e6));
}

/// "Re = 1208   density omega_max r_o^2 / viscosity", one line each.
void print_groups(const Case& whole) {
  std::string name = "groups";
  for (const Group& group : groups(whole)) {
    const bool large = group.value >= 1000 && group.value < 1e6;
    const std::string value =
        large ? fmt::format("{:.0f}", group.value) : fmt::format("{:.3g}", group.value);
    print_line(name, columns(group.name + " = " + value, 18, group.meaning));
    name.clear();
  }
}

}  // namespace

int command_check(const CaseArguments& arguments) {
  const Case whole = read_case(arguments.path, arguments.settings);
  check_build(whole);
  print_line("case", fmt::format("{} ({})", whole.title.empty() ? "untitled" : whole.title,
                                 whole.dimension == 3 ? "3-D" : "2-D"));
  for (const Fact& fact : describe(whole)) print_line(fact.name, fact.value);
  print_memory(whole);
  print_groups(whole);
  for (const std::string& note : whole.notes) print_line("note", note);
  for (const std::string& doubt : doubts(whole)) print_line("warning", doubt);
  return 0;
}

}  // namespace washtub
