#include <cmath>

#include "washer/case_tables.hpp"

namespace washtub {
namespace {

bool is_book(const ClothCase& cloth, int) { return cloth.arrangement == Arrangement::book; }
bool is_sheet(const ClothCase& cloth, int) { return cloth.arrangement == Arrangement::sheet; }
bool is_placed(const ClothCase& cloth, int dimension) { return !is_sheet(cloth, dimension); }
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
      .required();
}

void add_book(Table<ClothCase>& table) {
  table
      .key("inner_radius", &ClothCase::inner_radius, quantity(measure::length, at_least(0)),
           "book: from the axis to the inner edge")
      .fallback("0.477 of the tub radius")
      .only("for \"book\"", is_book)
      .key("bottom", &ClothCase::bottom, quantity(measure::length, at_least(0)),
           "book: height of the lower edge")
      .fallback("0.328 of the water depth")
      .only("for \"book\"", is_book)
      .key("shift", &ClothCase::shift, quantity(measure::length, at_least(0)),
           "book: standard deviation of the random shift")
      .fallback("0.0129 of the tub radius")
      .only("for \"book\"", is_book)
      .key("tilt", &ClothCase::tilt, quantity(measure::angle, at_least(0)),
           "book: standard deviation of the random tilt")
      .fallback("4 deg")
      .only("for \"book\"", is_book)
      .key("clearance", &ClothCase::clearance, quantity(measure::length, at_least(0)),
           "smallest distance to solids, surface and other pieces")
      .fallback("0.0129 of the tub radius")
      .only("for \"book\" and \"random\"", is_placed);
}

/// Pointer to a direction of a sheet.
template <size_t i>
Vec<3>& along(ClothCase& cloth) {
  return cloth.along[i];
}

void add_sheet(Table<ClothCase>& table) {
  table.key("origin", &ClothCase::origin, vector(measure::length), "sheet: its first corner")
      .only("for \"sheet\"", is_sheet)
      .key("along_r", along<0>, direction(), "sheet: direction of its first edge")
      .only("for \"sheet\"", is_sheet)
      .key("along_s", along<1>, direction(), "sheet: direction of its second edge")
      .only("for \"sheet\" in 3-D", [](const ClothCase& cloth, int dimension) {
        return dimension == 3 && is_sheet(cloth, dimension);
      });
}

/// Makes unit vectors of the directions of a sheet, and refuses those that span none.
void normalise(ClothCase& cloth, const Node& node, int dimension) {
  if (!is_sheet(cloth, dimension)) return;
  for (Vec<3>& direction : cloth.along) {
    if (direction.norm() == 0) throw error_at(node, "along_r and along_s must not be zero");
    if (std::abs(direction.norm() - 1) > 1e-12) direction.normalize();
  }
  if (dimension == 3 && std::abs(cloth.along[0].dot(cloth.along[1])) > 1e-9)
    throw error_at(node, "along_r and along_s must be at right angles");
}

}  // namespace

Table<ClothCase> cloth_table() {
  Table<ClothCase> table(
      "A group of equal pieces of cloth. Repeat `[[cloth]]` for several groups. Lengths of the "
      "start default to proportions of the washer; without `[washer]` to 0.");
  table.key("count", &ClothCase::count, integer(between(0, 100000)), "number of pieces")
      .key("seed", &ClothCase::seed, seed(), "of the random numbers of the start")
      .key("size", &ClothCase::size, extents(measure::length, above(0)),
           "edge lengths; in 2-D the length alone")
      .required()
      .key("nodes", &ClothCase::nodes, sheet_counts(between(3, 4096)), "nodes along the edges")
      .fallback("from `spacing`")
      .omitted([](const ClothCase& cloth, int) { return cloth.nodes[0] == 0; })
      .key("spacing", &ClothCase::spacing, number(between(0.5, 8)),
           "node spacing in lateral cells, where `nodes` is not given")
      .key("arrangement", &ClothCase::arrangement,
           choice<Arrangement>({{"book", Arrangement::book},
                                {"random", Arrangement::random},
                                {"sheet", Arrangement::sheet}}),
           "start: pages of a book about the axis, at random, or one flat sheet");
  add_material(table);
  add_book(table);
  add_sheet(table);
  table.then(normalise);
  return table;
}

std::array<int, 2> cloth_nodes(const ClothCase& cloth, const Case& whole) {
  if (cloth.nodes[0] > 0) return cloth.nodes;
  const double lateral = whole.domain.size.x() / whole.domain.cells[0];
  const int second = whole.dimension == 3 ? 1 : 0;
  std::array<int, 2> nodes = {1, 1};
  for (size_t i = 0; i <= static_cast<size_t>(second); ++i)
    nodes[i] = static_cast<int>(std::lround(cloth.size[i] / (cloth.spacing * lateral))) + 1;
  return nodes;
}

}  // namespace washtub
