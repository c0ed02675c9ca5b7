#include "case/tables.hpp"

namespace washtub {
namespace {

constexpr std::array<const char*, 6> side_names = {"x_lower", "x_upper", "y_lower",
                                                   "y_upper", "z_lower", "z_upper"};

const std::vector<std::pair<std::string, SideKind>>& side_kinds() {
  static const std::vector<std::pair<std::string, SideKind>> kinds = {
      {"no-slip", SideKind::no_slip},    {"slip", SideKind::slip},
      {"periodic", SideKind::periodic},  {"moving-wall", SideKind::moving_wall},
      {"inflow", SideKind::inflow},      {"outflow", SideKind::outflow},
      {"far-field", SideKind::far_field}};
  return kinds;
}

const std::vector<std::pair<std::string, Mapping>>& mappings() {
  static const std::vector<std::pair<std::string, Mapping>> kinds = {
      {"sharp", Mapping::sharp}, {"smooth", Mapping::smooth}, {"gradual", Mapping::gradual}};
  return kinds;
}

/// Keys of one side: its kind, and the velocity of a moving wall or of the water that enters.
void add_side(Table<DomainCase>& table, size_t side) {
  const std::string name = side_names[side];
  auto exists = [side](const DomainCase&, int dimension) { return side < 4 || dimension == 3; };
  auto moves = [=](const DomainCase& domain, int dimension) {
    const SideKind kind = domain.sides[side].kind;
    return exists(domain, dimension) && (kind == SideKind::moving_wall || kind == SideKind::inflow);
  };
  table.key(
      name, [side](DomainCase& domain) -> SideKind& { return domain.sides[side].kind; },
      choice<SideKind>(side_kinds()),
      "condition on that side; periodic sides come in pairs; water leaves through outflow "
      "and passes through far-field, the side of a stream");
  if (side >= 4) table.only("in 3-D", exists);
  table
      .key(
          name + "_velocity",
          [side](DomainCase& domain) -> Vec<3>& { return domain.sides[side].velocity; },
          vector(measure::speed), "of the wall, along itself; or of the water that enters")
      .only("for a moving wall or an inflow", moves)
      .required();
}

Table<DomainCase> sides_table() {
  Table<DomainCase> table("Conditions on the sides of the box.");
  for (size_t side = 0; side < side_names.size(); ++side) add_side(table, side);
  return table;
}

}  // namespace

std::string side_name(SideKind kind) {
  for (const auto& [name, other] : side_kinds())
    if (other == kind) return name;
  return "";
}

std::string mapping_name(Mapping mapping) {
  for (const auto& [name, other] : mappings())
    if (other == mapping) return name;
  return "";
}

Table<FluidCase> fluid_table() {
  Table<FluidCase> table("The water.");
  table.key("density", &FluidCase::density, quantity(measure::density, above(0)), "density, rho")
      .key("viscosity", &FluidCase::viscosity, quantity(measure::viscosity, above(0)),
           "dynamic viscosity, mu; of real water 1e-3 Pa s, far below what the grid resolves")
      .required()
      .key("gravity", &FluidCase::gravity, vector(measure::acceleration),
           "pulls at the excess mass of cloth")
      .key("velocity", &FluidCase::velocity, formulas(measure::speed, false),
           "of the water at t = 0");
  return table;
}

Table<DomainCase> domain_table() {
  Table<DomainCase> table("The box of water and its grid.");
  table.key("lower", &DomainCase::lower, vector(measure::length), "lower corner of the box")
      .key("size", &DomainCase::size, vector(measure::length, above(0)), "edge lengths of the box")
      .required([](const DomainCase& domain, int) { return domain.size.x() == 0; })
      .fallback("required without `[washer]`")
      .key("cells", &DomainCase::cells, counts(between(8, 8192)), "number of cells")
      .required()
      .key("mapping", &DomainCase::mapping, choice<Mapping>(mappings()),
           "how solids act on the water: Heaviside function of Eq. (9), as in the paper; `gradual` "
           "places walls to second order in the cell, and faces do not open or close at once")
      .key("mapping_width", &DomainCase::mapping_width, number(above(0)),
           "half width of the smooth mapping in cells, gamma of Eq. (11)")
      .only("with `mapping = \"smooth\"`",
            [](const DomainCase& domain, int) { return domain.mapping == Mapping::smooth; })
      .key("mapping_shift", &DomainCase::mapping_shift, number(between(0, 0.5)),
           "how far outside a solid the sharp mapping still closes faces, in cell widths along the "
           "normal; 0 as in the paper, 0.17 where surfaces are curved or oblique")
      .only("with `mapping = \"sharp\"`",
            [](const DomainCase& domain, int) { return domain.mapping == Mapping::sharp; })
      .table(
          "sides", [](DomainCase& domain) -> DomainCase& { return domain; }, sides_table());
  return table;
}

}  // namespace washtub
