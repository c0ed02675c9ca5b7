#include "case/description.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace washtub {
namespace {

constexpr double degree = std::numbers::pi / 180;

/// Entries of the axes in use, "0.7 x 0.7 x 0.2".
template <class List>
std::string product(const List& list, int dimension) {
  std::vector<std::string> texts;
  for (int axis = 0; axis < dimension; ++axis)
    texts.push_back(
        fmt::format("{:.6g}", static_cast<double>(list[static_cast<std::size_t>(axis)])));
  return fmt::format("{}", fmt::join(texts, " x "));
}

std::string grid_text(const Case& whole) {
  const DomainCase& domain = whole.domain;
  Vec<3> spacing = domain.size;
  for (int axis = 0; axis < whole.dimension; ++axis)
    spacing[axis] /= domain.cells[static_cast<std::size_t>(axis)];
  return fmt::format("{} cells of {} m in a box of {} m, h/r_o = {:.4g}, {} mapping of solids",
                     product(domain.cells, whole.dimension), product(spacing, whole.dimension),
                     product(domain.size, whole.dimension), spacing.x() / whole.scale.length,
                     mapping_name(domain.mapping));
}

/// Angle between the extremes that a drive reaches in a period [rad]; 0 where it does not come
/// back.
double swing(const Drive& drive) {
  constexpr int samples = 1000;
  double least = 0, largest = 0, angle = 0;
  for (int i = 0; i <= samples; ++i) {
    angle = drive.angle(drive.period() * i / samples);
    least = std::min(least, angle);
    largest = std::max(largest, angle);
  }
  return std::abs(angle) < 1e-6 * (largest - least) ? largest - least : 0;
}

std::string side_text(const SideCase& side, int dimension) {
  if (side.kind != SideKind::moving_wall && side.kind != SideKind::inflow)
    return side_name(side.kind);
  std::vector<std::string> parts;
  for (int axis = 0; axis < dimension; ++axis)
    parts.push_back(fmt::format("{:.4g}", side.velocity[axis]));
  return fmt::format("{} ({}) m/s", side_name(side.kind), fmt::join(parts, ", "));
}

std::string cloth_text(const ClothCase& cloth, const Case& whole) {
  const int directions = whole.dimension - 1;
  const double lateral = whole.domain.size.x() / whole.domain.cells[0];
  const std::string name = whole.cloth.size() > 1 ? cloth.name + ": " : "";
  return fmt::format("{}{} {} of {} m, {} nodes, {:.3g} lateral cells apart", name, cloth.count,
                     cloth.count == 1 ? "piece" : "pieces", product(cloth.size, directions),
                     product(cloth_nodes(cloth, whole), directions),
                     cloth_spacing(cloth, whole)[0] / lateral);
}

std::string time_text(const Case& whole) {
  const TimeCase& time = whole.time;
  std::string text = fmt::format("to {:.6g} s", time.end);
  if (whole.scale.period > 0)
    text += fmt::format(" ({:.4g} periods)", time.end / whole.scale.period);
  if (time.step > 0)
    text += fmt::format(", steps {} {:.4g} s: {:.0f} {}", time.fixed ? "of" : "up to", time.step,
                        time.end / time.step, time.fixed ? "steps" : "or more");
  if (!time.fixed) text += fmt::format(", CFL up to {:.3g}", time.cfl);
  return text;
}

std::string settle_text(const Case& whole) {
  const SettleCase& settle = whole.settle;
  const Vec<3>& g = settle.gravity;
  std::string text =
      fmt::format("for up to {:.6g} s before that, under ({:.4g}, {:.4g}{}) m/s^2", settle.time,
                  g[0], g[1], whole.dimension == 3 ? fmt::format(", {:.4g}", g[2]) : "");
  if (whole.time.step > 0)
    text += fmt::format(": up to about {:.0f} steps that no forecast counts",
                        settle.time / whole.time.step);
  return text;
}

std::string output_text(const OutputCase& output) {
  const std::string frames = output.frames > 0 ? fmt::format("frames every {:.4g} s", output.frames)
                                               : std::string("no frames");
  return fmt::format("every {:.4g} s, {}, statistics {:.6g} to {:.6g} s", output.every, frames,
                     output.window_begin, output.window_end);
}

std::string scales_text(const ScaleCase& scale) {
  const std::string speed =
      scale.speed > 0 ? fmt::format("omega_max = {:.6g} rad/s", scale.speed) : "no speed";
  return fmt::format("r_o = {:.6g} m, {}, H = {:.6g} m", scale.length, speed, scale.height);
}

}  // namespace

std::string sides_text(const Case& whole) {
  constexpr const char* axes[] = {"x", "y", "z"};
  std::vector<std::string> texts;
  for (int axis = 0; axis < whole.dimension; ++axis) {
    const auto first = static_cast<std::size_t>(2 * axis);
    const std::string lower = side_text(whole.domain.sides[first], whole.dimension);
    const std::string upper = side_text(whole.domain.sides[first + 1], whole.dimension);
    texts.push_back(lower == upper
                        ? fmt::format("{} {}", axes[axis], lower)
                        : fmt::format("{} {} (lower) and {} (upper)", axes[axis], lower, upper));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

std::string drive_text(const Drive& drive) {
  if (!drive.moving()) return "at rest";
  std::string text = fmt::format("turns at up to {:.6g} rpm", drive.peak() * 30 / std::numbers::pi);
  if (drive.period() <= 0) return text;
  text += fmt::format(", period {:.6g} s", drive.period());
  const double angle = swing(drive);
  return angle > 0 ? text + fmt::format(", {:.4g} deg to and fro", angle / degree) : text;
}

std::vector<Fact> describe(const Case& whole) {
  std::vector<Fact> facts = {{"grid", grid_text(whole)},
                             {"sides", sides_text(whole)},
                             {"scales", scales_text(whole.scale)}};
  for (const SolidCase& solid : whole.solids)
    facts.push_back({"solid", fmt::format("{}: {}", solid.name, drive_text(solid.drive))});
  for (const ClothCase& cloth : whole.cloth) facts.push_back({"cloth", cloth_text(cloth, whole)});
  facts.push_back({"time", time_text(whole)});
  if (whole.settle.time > 0) facts.push_back({"settles", settle_text(whole)});
  facts.push_back({"output", output_text(whole.output)});
  return facts;
}

}  // namespace washtub
