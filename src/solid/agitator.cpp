#include "solid/agitator.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/error.hpp"

namespace washtub {
namespace {

void require_positive(const char* name, double value) {
  if (!(value > 0) || !std::isfinite(value))
    throw InputError(
        fmt::format("agitator: {} = {} m: expected a positive, finite length", name, value));
}

void require_below(const char* name, double value, const char* limit_name, double limit) {
  if (!(value < limit))
    throw InputError(fmt::format("agitator: {} = {} m: expected less than {} = {} m", name, value,
                                 limit_name, limit));
}

void require_fins(int fins) {
  if (fins < 0) throw InputError(fmt::format("agitator: fins = {}: expected 0 or more", fins));
}

void validate(const Agitator3d& a) {
  require_positive("rim_radius", a.rim_radius);
  require_positive("rim_height", a.rim_height);
  require_positive("skirt_top_radius", a.skirt_top_radius);
  require_positive("skirt_top_height", a.skirt_top_height);
  require_positive("hub_radius", a.hub_radius);
  require_positive("hub_height", a.hub_height);
  require_below("skirt_top_radius", a.skirt_top_radius, "rim_radius", a.rim_radius);
  require_fins(a.fins);
  if (a.fins == 0) return;
  require_positive("fin_half_thickness", a.fin_half_thickness);
  require_positive("fin_root_height", a.fin_root_height);
  require_positive("fin_tip_height", a.fin_tip_height);
  require_below("hub_radius", a.hub_radius, "fin_radius", a.fin_radius);
}

void validate(const Agitator2d& a) {
  require_positive("hub_radius", a.hub_radius);
  require_fins(a.fins);
  if (a.fins == 0) return;
  require_positive("fin_radius", a.fin_radius);
  require_positive("fin_half_width", a.fin_half_width);
}

Shape around(const Shape& fin, int k, int fins) {
  return rotate_z(fin, 2 * std::numbers::pi * k / fins);
}

}  // namespace

Agitator3d reference_agitator_3d(double tub_radius, double depth) {
  return {.rim_radius = 0.70 * tub_radius,
          .rim_height = 0.04 * depth,
          .skirt_top_radius = 0.12 * tub_radius,
          .skirt_top_height = 0.70 * depth,
          .hub_radius = 0.12 * tub_radius,
          .hub_height = 0.75 * depth,
          .fins = 3,
          .fin_half_thickness = 0.035 * tub_radius,
          .fin_radius = 0.45 * tub_radius,
          .fin_root_height = 0.75 * depth,
          .fin_tip_height = 0.45 * depth};
}

Agitator2d reference_agitator_2d(double tub_radius) {
  return {.hub_radius = 0.16 * tub_radius,
          .fins = 3,
          .fin_radius = 0.62 * tub_radius,
          .fin_half_width = 0.035 * tub_radius};
}

Shape shape(const Agitator3d& a) {
  validate(a);
  const double foot = -a.rim_radius;
  std::vector<Shape> parts = {revolution({{0, foot},
                                          {a.rim_radius, foot},
                                          {a.rim_radius, a.rim_height},
                                          {a.skirt_top_radius, a.skirt_top_height},
                                          {0, a.skirt_top_height}}),
                              cylinder(a.hub_radius, foot, a.hub_height),
                              sphere({0, 0, a.hub_height}, a.hub_radius)};
  if (a.fins == 0) return unite(parts);
  const Shape fin = plate({{0, foot},
                           {a.fin_radius, foot},
                           {a.fin_radius, a.fin_tip_height},
                           {a.hub_radius, a.fin_root_height},
                           {0, a.fin_root_height}},
                          a.fin_half_thickness);
  for (int k = 0; k < a.fins; ++k) parts.push_back(around(fin, k, a.fins));
  return unite(parts);
}

Shape shape(const Agitator2d& a) {
  validate(a);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<Shape> parts = {cylinder(a.hub_radius, -infinity, infinity)};
  if (a.fins == 0) return unite(parts);
  const Shape fin = capsule(Vec<3>::Zero(), {a.fin_radius, 0, 0}, a.fin_half_width);
  for (int k = 0; k < a.fins; ++k) parts.push_back(around(fin, k, a.fins));
  return unite(parts);
}

}  // namespace washtub
