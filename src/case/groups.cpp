#include "case/groups.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace washtub {
namespace {

/// Longest edge of a cell [m].
double cell_edge(const Case& whole) {
  double edge = 0;
  for (int axis = 0; axis < whole.dimension; ++axis)
    edge = std::max(edge,
                    whole.domain.size[axis] / whole.domain.cells[static_cast<std::size_t>(axis)]);
  return edge;
}

std::vector<Group> groups_of_water(const Case& whole) {
  const ScaleCase& scale = whole.scale;
  const double momentum = whole.fluid.density * scale.speed * scale.length;
  std::vector<Group> result = {{"Re", momentum * scale.length / whole.fluid.viscosity,
                                "density omega_max r_o^2 / viscosity"}};
  if (scale.period > 0)
    result.push_back({"St", 1 / scale.period / scale.speed, "1 / (period of the drive omega_max)"});
  result.push_back({"Re_h", momentum * cell_edge(whole) / whole.fluid.viscosity,
                    "density omega_max r_o h / viscosity, h the longest edge of a cell"});
  return result;
}

std::vector<Group> groups_of_cloth(const ClothCase& cloth, const Case& whole) {
  const Material& m = cloth.material;
  const double r = whole.scale.length, density = whole.fluid.density;
  const double inertia = density * whole.scale.speed * whole.scale.speed * r * r * r;
  std::vector<Group> result = {
      {"Te", m.stretch / inertia, "stretch stiffness / (density omega_max^2 r_o^3)"},
      {"Be", m.bending / inertia / r / r, "bending stiffness / (density omega_max^2 r_o^5)"}};
  if (whole.dimension == 3) {
    result.push_back({"Se", m.shear / inertia, "shear stiffness / (density omega_max^2 r_o^3)"});
    result.push_back(
        {"To", m.torsion / inertia / r / r, "torsion stiffness / (density omega_max^2 r_o^5)"});
  }
  result.push_back({"In", m.excess_mass / density / r, "excess mass per area / (density r_o)"});
  return result;
}

/// Whether all cloth of the case has the groups of the first one.
bool all_alike(const Case& whole) {
  const auto first = groups_of_cloth(whole.cloth.front(), whole);
  return std::all_of(whole.cloth.begin(), whole.cloth.end(), [&](const ClothCase& cloth) {
    const auto other = groups_of_cloth(cloth, whole);
    return std::equal(first.begin(), first.end(), other.begin(),
                      [](const Group& a, const Group& b) { return a.value == b.value; });
  });
}

}  // namespace

std::optional<Scales> scales(const Case& whole) {
  const double r = whole.scale.length, w = whole.scale.speed;
  if (r <= 0 || w <= 0) return {};
  const double stress = whole.fluid.density * r * r * w * w;
  return Scales{stress, stress * r * r * (whole.dimension == 3 ? whole.scale.height : 1)};
}

std::vector<Group> groups(const Case& whole) {
  if (!scales(whole)) return {};
  std::vector<Group> result = groups_of_water(whole);
  const std::size_t kinds = whole.cloth.empty() ? 0 : all_alike(whole) ? 1 : whole.cloth.size();
  for (std::size_t i = 0; i < kinds; ++i)
    for (Group group : groups_of_cloth(whole.cloth[i], whole)) {
      if (kinds > 1) group.name += " of " + whole.cloth[i].name;
      result.push_back(std::move(group));
    }
  return result;
}

}  // namespace washtub
