#include <algorithm>
#include <numbers>

#include "case/tables.hpp"

namespace washtub {
namespace {

bool unused(const ContactCase& contact, int) { return contact.scheme != ContactScheme::layers; }

/// Area of all cloth [m^2]; in 2-D length [m].
double cloth_area(const Case& whole) {
  double area = 0;
  for (const ClothCase& cloth : whole.cloth)
    area += cloth.count * cloth.size[0] * (whole.dimension == 3 ? cloth.size[1] : 1);
  return area;
}

/// Within the tub, or what is as wide as the box [m^3]; in 2-D area [m^2].
double water_volume(const Case& whole) {
  const double height = whole.dimension == 3 ? whole.domain.size.z() : 1;
  return std::numbers::pi * whole.scale.length * whole.scale.length * height;
}

/// Stops the fastest water, or bears the weight of a few layers of the heaviest cloth.
double default_pressure(const Case& whole, double range) {
  const double speed = whole.scale.speed * whole.scale.length;
  const double creep = whole.fluid.viscosity / (whole.fluid.density * range);
  const double settling = whole.settle.time > 0 ? whole.settle.gravity.norm() : 0;
  double heaviest = 0;
  for (const ClothCase& cloth : whole.cloth)
    heaviest = std::max(heaviest, cloth.material.excess_mass);
  return std::max({0.25 * whole.fluid.density * speed * speed,
                   10 * heaviest * std::max(whole.fluid.gravity.norm(), settling),
                   whole.fluid.density * creep * creep});
}

}  // namespace

Table<ContactCase> contact_table() {
  Table<ContactCase> table(
      "What cloth does to cloth and solids that it touches. Without cloth it has no effect.");
  table
      .key(
          "scheme", &ContactCase::scheme,
          choice<ContactScheme>({{"layers", ContactScheme::layers}, {"none", ContactScheme::none}}),
          "layers: cloth repels cloth within a range, keeps a gap and never crosses, and nears and "
          "slides along solids softly; none: as in the paper, cloth passes through cloth, and "
          "nodes stop hard at solids")
      .key("range", &ContactCase::range, quantity(measure::length, above(0)),
           "distance within which sheets repel each other")
      .fallback(
          "1.5 lateral cells; 1 where cloth of that thickness would fill a third of the water")
      .omitted(unused)
      .key("pressure", &ContactCase::pressure, quantity(measure::pressure, at_least(0)),
           "scale P of the repulsion P (1 - d/range)^2 range/d")
      .fallback(
          "a quarter of density times the square of the fastest speed, or ten times the "
          "weight of the heaviest cloth, in settling too")
      .omitted(unused)
      .key("gap", &ContactCase::gap, quantity(measure::length, above(0)),
           "least distance that sheets keep")
      .fallback("a tenth of a lateral cell, or the cloth's thickness")
      .omitted(unused)
      .key("solid_time", &ContactCase::solid_time, quantity(measure::time, at_least(0)),
           "time constant with which a node may near a solid; 0 s: it stops at half a cell")
      .omitted(unused)
      .key("untangle", &ContactCase::untangle, boolean(),
           "pieces that start through each other or nearer than `gap` are moved apart first, as "
           "they are; otherwise they are refused")
      .omitted(unused);
  return table;
}

void check_contact(const Case& whole, const Node& root) {
  const ContactCase& contact = whole.contact;
  if (contact.scheme == ContactScheme::none || contact.gap < contact.range) return;
  throw error_at_key(root, find_key(root, "contact.gap") ? "contact.gap" : "contact.range", "",
                     fmt::format("the gap that sheets keep is {} and the range within which they "
                                 "repel each other {}, allowed: a gap below the range",
                                 metres(contact.gap), metres(contact.range)));
}

ContactCase complete_contact(const Case& whole) {
  ContactCase contact = whole.contact;
  const double lateral = whole.domain.size.x() / whole.domain.cells[0];
  if (contact.range == 0) {
    const bool crowded = cloth_area(whole) * 1.5 * lateral > water_volume(whole) / 3;
    contact.range = (crowded ? 1 : 1.5) * lateral;
  }
  if (contact.gap == 0) {
    contact.gap = 0.1 * lateral;
    for (const ClothCase& cloth : whole.cloth)
      contact.gap = std::max(contact.gap, cloth.material.thickness);
    contact.gap = std::min(contact.gap, 0.5 * contact.range);
  }
  if (contact.pressure < 0) contact.pressure = default_pressure(whole, contact.range);
  return contact;
}

}  // namespace washtub
