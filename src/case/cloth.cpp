#include <algorithm>
#include <cmath>

#include "case/tables.hpp"

namespace washtub {
namespace {

bool in_space(const ClothCase&, int dimension) { return dimension == 3; }

template <double Material::*member>
double& material(ClothCase& cloth) {
  return cloth.material.*member;
}

void add_material(Table<ClothCase>& table) {
  table
      .key("stretch_stiffness", material<&Material::stretch>,
           quantity(measure::stiffness, above(0)), "K_e of Eq. (14)")
      .required()
      .key("shear_stiffness", material<&Material::shear>, quantity(measure::stiffness, at_least(0)),
           "K_s")
      .only("in 3-D", in_space)
      .key("bending_stiffness", material<&Material::bending>,
           quantity(measure::bending, at_least(0)), "K_b")
      .required()
      .key("torsion_stiffness", material<&Material::torsion>,
           quantity(measure::bending, at_least(0)), "K_t")
      .only("in 3-D", in_space)
      .key("poisson", material<&Material::poisson>, number(between(0, 0.5)),
           "nu of the cross terms")
      .key("excess_mass", material<&Material::excess_mass>,
           quantity(measure::areal_mass, at_least(0)), "mass beyond that of the displaced water")
      .key("thickness", material<&Material::thickness>, quantity(measure::length, above(0)),
           "q, by which forces become stresses")
      .required()
      .key("loss_time", material<&Material::loss_time>, quantity(measure::time, at_least(0)),
           "tau of the membrane's stress K (E + tau dE/dt); for coupling.scheme = \"implicit\" "
           "only")
      .key("friction", material<&Material::friction>, number(at_least(0)),
           "Coulomb's coefficient against cloth of its kind; between two kinds the geometric mean")
      .key("solid_friction", material<&Material::solid_friction>, number(at_least(0)),
           "Coulomb's coefficient against solids and the sides of the box");
}

}  // namespace

Table<ClothCase> cloth_table() {
  Table<ClothCase> table(
      "A group of equal pieces of cloth. Repeat `[[cloth]]` for several groups. Lengths of the "
      "start default to proportions of the washer; without `[washer]` to 0.");
  table.key("count", &ClothCase::count, integer(between(0, 100000)), "number of pieces")
      .key("seed", &ClothCase::seed, seed(), "of the random numbers of the start")
      .key("size", &ClothCase::size, extents(measure::length, above(0)),
           "edge lengths at rest; in 2-D the length alone")
      .required()
      .key("nodes", &ClothCase::nodes, sheet_counts(between(3, most_nodes)),
           "nodes along the edges")
      .fallback("from `spacing`")
      .omitted([](const ClothCase& cloth, int) { return cloth.nodes[0] == 0; })
      .key("spacing", &ClothCase::spacing, number(between(0.5, 8)),
           "node spacing in lateral cells, where `nodes` is not given")
      .key("arrangement", &ClothCase::arrangement,
           choice<Arrangement>({{"book", Arrangement::book},
                                {"random", Arrangement::random},
                                {"sheet", Arrangement::sheet},
                                {"ring", Arrangement::ring}}),
           "start: pages of a book about the axis, at random, one sheet, or a closed ring (2-D)");
  add_material(table);
  add_start(table);
  return table;
}

bool is_held(const std::vector<Edge>& held, int direction, int end) {
  return std::count(held.begin(), held.end(), static_cast<Edge>(2 * direction + end)) > 0;
}

double intervals(const ClothCase& cloth, int direction, int nodes) {
  const bool ring = cloth.arrangement == Arrangement::ring;
  if (ring || cloth.closed[static_cast<size_t>(direction)]) return nodes;
  const int clamps = is_held(cloth.clamped, direction, 0) + is_held(cloth.clamped, direction, 1);
  return nodes - 1 - 0.5 * clamps;
}

std::array<int, 2> cloth_nodes(const ClothCase& cloth, const Case& whole) {
  if (cloth.nodes[0] > 0) return cloth.nodes;
  const double lateral = whole.domain.size.x() / whole.domain.cells[0];
  std::array<int, 2> nodes = {1, 1};
  for (int d = 0; d + 1 < whole.dimension; ++d) {
    const auto i = static_cast<size_t>(d);
    const double wanted = cloth.size[i] / (cloth.spacing * lateral);
    nodes[i] =
        static_cast<int>(std::lround(std::min(wanted - intervals(cloth, d, 0), most_nodes + 1.0)));
  }
  return nodes;
}

std::array<double, 2> cloth_spacing(const ClothCase& cloth, const Case& whole) {
  const auto nodes = cloth_nodes(cloth, whole);
  std::array<double, 2> spacing = {0, 0};
  for (int d = 0; d + 1 < whole.dimension; ++d) {
    const auto i = static_cast<size_t>(d);
    spacing[i] = cloth.size[i] / intervals(cloth, d, nodes[i]);
  }
  return spacing;
}

}  // namespace washtub
