#include <algorithm>
#include <set>

#include "case/tables.hpp"

namespace washtub {
namespace {

std::string seconds(double time) { return fmt::format("\"{:.6g} s\"", time); }

void check_box(const CaseFile& file, const Node& root) {
  if (!file.washer) return;
  const DomainCase& domain = file.result.domain;
  const double radius = file.washer->radius;
  for (int axis = 0; axis < 2; ++axis)
    if (domain.lower[axis] > -radius || domain.lower[axis] + domain.size[axis] < radius)
      throw error_at_key(root, find_key(root, "domain.size") ? "domain.size" : "domain.lower", "",
                         fmt::format("the tub does not fit into the box, allowed: from {} to {} at "
                                     "least along x and y",
                                     metres(-radius), metres(radius)));
}

/// Sizes and speed that follow from other keys may exceed what a key itself may be.
void check_magnitudes(const Case& whole, const Node& root) {
  if (!(whole.domain.size.maxCoeff() <= largest_quantity))
    throw error_at_key(root, "washer.radius", "",
                       fmt::format("leads to a box wider than {:g} m", largest_quantity));
  if (!(whole.scale.speed <= largest_quantity))
    throw error_at_key(
        root, "scale.speed", fmt::format("\"{:g} rad/s\"", whole.scale.speed),
        fmt::format("allowed: up to \"{:g} rad/s\"; try a larger scale.length", largest_quantity));
}

void check_names(const CaseFile& file, const Node& root) {
  std::set<std::string> seen;
  std::set<std::string> groups;
  for (const SolidCase& solid : file.result.solids) groups.insert(solid.name);
  const auto& cloth = file.result.cloth;
  for (size_t i = 0; i < cloth.size(); ++i)
    if (!groups.insert(cloth[i].name).second)
      throw error_at_key(root, cloth_key(i, cloth.size(), "name"), cloth[i].name,
                         "a solid or another group of cloth has this name");
  for (const SolidSpec& solid : file.solids)
    if (!seen.insert(solid.name).second)
      throw InputError(fmt::format("{}: solid.name = \"{}\": two solids have this name", root.where,
                                   solid.name));
}

void check_times(const Case& whole, const Node& root) {
  const TimeCase& time = whole.time;
  const OutputCase& output = whole.output;
  if (time.fixed && time.step == 0)
    throw error_at_key(root, "time.fixed", "true", "expected time.step along with it");
  if (output.window_begin >= output.window_end || output.window_end > time.end * (1 + 1e-9))
    throw error_at_key(root, "output.window", "",
                       fmt::format("allowed: a begin before the end, both from \"0 s\" to {} "
                                   "(time.end)",
                                   seconds(time.end)));
  if (output.every > time.end)
    throw error_at_key(root, "output.every", seconds(output.every),
                       fmt::format("allowed: up to {} (time.end)", seconds(time.end)));
  if (time.fixed && output.every < time.step * (1 - 1e-9))
    throw error_at_key(
        root, "output.every", seconds(output.every),
        fmt::format("allowed: at least the fixed time.step, {}", seconds(time.step)));
}

}  // namespace

InputError error_at_key(const Node& root, const std::string& key, const std::string& value,
                        const std::string& message) {
  if (const Node* node = find_key(root, key)) return error_at(*node, message);
  const std::string is = value.empty() ? "" : " = " + value + " (default)";
  return InputError(fmt::format("{}: {}{}: {}", root.where, key, is, message));
}

std::string metres(double length) { return fmt::format("\"{:.6g} m\"", length); }

void check_case(const CaseFile& file, const Node& root) {
  check_magnitudes(file.result, root);
  check_sides(file.result, root);
  check_box(file, root);
  check_names(file, root);
  check_solids(file, root);
  check_times(file.result, root);
  check_cloth(file, root);
  check_probes(file.result, root);
  check_contact(file.result, root);
  check_settle(file.result, root);
}

}  // namespace washtub
