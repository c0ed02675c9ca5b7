#include "case/preset.hpp"

#include <numbers>

namespace washtub {
namespace {

SolidCase tub_solid(const WasherSpec& washer) {
  constexpr double unbounded = ShapeSpec::unbounded;
  SolidCase tub;
  tub.name = "tub";
  tub.shape = complement(cylinder(washer.radius, -unbounded, unbounded));
  return tub;
}

Shape agitator_shape(const Agitator3d& agitator, int dimension) {
  if (dimension == 3) return shape(agitator);
  return shape(Agitator2d{.hub_radius = agitator.hub_radius,
                          .fins = agitator.fins,
                          .fin_radius = agitator.fin_radius,
                          .fin_half_width = agitator.fin_half_thickness});
}

SolidCase agitator_solid(const WasherSpec& washer, int dimension) {
  SolidCase solid;
  solid.name = "agitator";
  solid.shape = agitator_shape(washer.agitator, dimension);
  solid.drive = drive_kinds().make(washer.stroke, dimension);
  return solid;
}

/// The reference agitator for this tub.
Agitator3d reference_agitator(const WasherSpec& washer, int dimension) {
  if (dimension == 3) return reference_agitator_3d(washer.radius, washer.depth);
  const Agitator2d flat = reference_agitator_2d(washer.radius);
  Agitator3d agitator;
  agitator.hub_radius = flat.hub_radius;
  agitator.fin_radius = flat.fin_radius;
  agitator.fin_half_thickness = flat.fin_half_width;
  return agitator;
}

}  // namespace

DriveSpec paper_stroke() {
  DriveSpec stroke;
  stroke.kind = "sinusoid";
  stroke.peak = 4 * std::numbers::pi;
  stroke.frequency = 2 / std::numbers::pi;
  return stroke;
}

void complete(WasherSpec& washer, int dimension) {
  if (dimension == 2) washer.depth = 1;
  const Agitator3d reference = reference_agitator(washer, dimension);
  for (double Agitator3d::*length :
       {&Agitator3d::rim_radius, &Agitator3d::rim_height, &Agitator3d::skirt_top_radius,
        &Agitator3d::skirt_top_height, &Agitator3d::hub_radius, &Agitator3d::hub_height,
        &Agitator3d::fin_half_thickness, &Agitator3d::fin_radius, &Agitator3d::fin_root_height,
        &Agitator3d::fin_tip_height})
    if (washer.agitator.*length == 0) washer.agitator.*length = reference.*length;
}

void fill_case(Case& result, const WasherSpec& washer) {
  const bool space = result.dimension == 3;
  const double width = (space ? 71.28 / 31 : 2.171) * washer.radius;
  result.domain.lower = {-width / 2, -width / 2, 0};
  result.domain.size = {width, width, space ? washer.depth : 0};
  result.domain.sides.fill(SideCase{});
  result.domain.sides[5].kind = SideKind::slip;
  result.solids = {tub_solid(washer), agitator_solid(washer, result.dimension)};
  result.scale.length = washer.radius;
  result.scale.height = washer.depth;
}

ClothCase default_cloth(const WasherSpec& washer, int dimension) {
  ClothCase cloth;
  cloth.arrangement = dimension == 3 ? Arrangement::book : Arrangement::random;
  cloth.inner_radius = 14.8 / 31 * washer.radius;
  cloth.bottom = 7.8 / 23.76 * washer.depth;
  cloth.shift = 0.4 / 31 * washer.radius;
  cloth.tilt = 4 * std::numbers::pi / 180;
  cloth.clearance = 0.4 / 31 * washer.radius;
  return cloth;
}

}  // namespace washtub
