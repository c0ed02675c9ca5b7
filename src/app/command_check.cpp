#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>
#include <span>

#include "app/commands.hpp"
#include "washer/build.hpp"
#include "washer/case.hpp"

namespace washtub {
namespace {

/// Bound of the design for fields, masks and multigrid levels of a cell [bytes].
constexpr double bytes_per_cell = 250;

void print_line(const std::string& name, const std::string& text) {
  fmt::print("{:<13}{}\n", name, text);
}

/// Entries of the axes in use, "0.7 x 0.7 x 0.2".
template <class List>
std::string product(const List& list, int dimension) {
  std::vector<std::string> texts;
  for (int axis = 0; axis < dimension; ++axis)
    texts.push_back(fmt::format("{:.6g}", static_cast<double>(list[static_cast<size_t>(axis)])));
  return fmt::format("{}", fmt::join(texts, " x "));
}

double cell_count(const Case& whole) {
  double cells = 1;
  for (int axis = 0; axis < whole.dimension; ++axis)
    cells *= whole.domain.cells[static_cast<size_t>(axis)];
  return cells;
}

void print_grid(const Case& whole) {
  const DomainCase& domain = whole.domain;
  Vec<3> spacing = domain.size;
  for (int axis = 0; axis < whole.dimension; ++axis)
    spacing[axis] /= domain.cells[static_cast<size_t>(axis)];
  print_line(
      "grid",
      fmt::format("{} cells of {} m in a box of {} m", product(domain.cells, whole.dimension),
                  product(spacing, whole.dimension), product(domain.size, whole.dimension)));
  print_line("",
             fmt::format("h/r_o = {:.4g}, {} mapping of solids", spacing.x() / whole.scale.length,
                         domain.mapping == Mapping::sharp ? "sharp" : "smooth"));
  print_line("memory",
             fmt::format("about {:.0f} MB", cell_count(whole) * bytes_per_cell / 1e6 + 30));
}

/// Dimensionless groups of Eqs. (18) and (19).
void print_groups(const Case& whole) {
  const ScaleCase& scale = whole.scale;
  const double r = scale.length, density = whole.fluid.density;
  const double inertia = density * scale.speed * scale.speed * r * r * r;
  print_line("scales", fmt::format("r_o = {:.6g} m, omega_max = {:.6g} rad/s, H = {:.6g} m", r,
                                   scale.speed, scale.height));
  std::string groups =
      fmt::format("Re = {:.4g}", density * r * r * scale.speed / whole.fluid.viscosity);
  if (scale.period > 0) groups += fmt::format(", St = {:.3g}", 1 / scale.period / scale.speed);
  print_line("groups", groups);
  for (const ClothCase& cloth : whole.cloth) {
    const Material& m = cloth.material;
    std::string text =
        fmt::format("Te = {:.4g}, Be = {:.3g}", m.stretch / inertia, m.bending / inertia / r / r);
    if (whole.dimension == 3)
      text +=
          fmt::format(", Se = {:.3g}, To = {:.3g}", m.shear / inertia, m.torsion / inertia / r / r);
    print_line("", text + fmt::format(", In = {:.3g}", m.excess_mass / density / r));
  }
}

std::string drive_text(const Drive& drive) {
  if (!drive.moving()) return "at rest";
  std::string text = fmt::format("turns at up to {:.6g} rpm", drive.peak() * 30 / std::numbers::pi);
  if (drive.period() > 0) text += fmt::format(", period {:.6g} s", drive.period());
  return text;
}

void print_solids(const Case& whole) {
  for (const SolidCase& solid : whole.solids)
    print_line("solid", fmt::format("{}: {}", solid.name, drive_text(solid.drive)));
}

void print_cloth(const Case& whole) {
  for (const ClothCase& cloth : whole.cloth) {
    const auto nodes = cloth_nodes(cloth, whole);
    const double lateral = whole.domain.size.x() / whole.domain.cells[0];
    const int directions = whole.dimension - 1;
    print_line("cloth",
               fmt::format("{} pieces of {} m, {} nodes, {:.3g} lateral cells apart", cloth.count,
                           product(cloth.size, directions), product(nodes, directions),
                           cloth_spacing(cloth, whole)[0] / lateral));
  }
}

void print_times(const Case& whole) {
  const TimeCase& time = whole.time;
  std::string text = fmt::format("to {:.6g} s", time.end);
  if (whole.scale.period > 0)
    text += fmt::format(" ({:.4g} periods)", time.end / whole.scale.period);
  if (time.step > 0)
    text += fmt::format(", steps {} {:.4g} s: {:.0f} {}", time.fixed ? "of" : "up to", time.step,
                        time.end / time.step, time.fixed ? "steps" : "or more");
  if (!time.fixed) text += fmt::format(", CFL up to {:.3g}", time.cfl);
  print_line("time", text);
  const OutputCase& output = whole.output;
  print_line("output",
             fmt::format("every {:.4g} s, frames every {:.4g} s, statistics {:.6g} to "
                         "{:.6g} s",
                         output.every, output.frames, output.window_begin, output.window_end));
}

}  // namespace

int command_check(const CaseArguments& arguments) {
  const Case whole = read_case(arguments.path, arguments.settings);
  check_build(whole);
  print_line("case", fmt::format("{} ({})", whole.title.empty() ? "untitled" : whole.title,
                                 whole.dimension == 3 ? "3-D" : "2-D"));
  print_grid(whole);
  print_groups(whole);
  print_solids(whole);
  print_cloth(whole);
  print_times(whole);
  return 0;
}

}  // namespace washtub
