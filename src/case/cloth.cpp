#include <algorithm>
#include <cmath>
#include <numbers>

#include "case/fabrics.hpp"
#include "case/tables.hpp"

namespace washtub {
namespace {

constexpr double air_viscosity = 1.8e-5;  // [Pa s]
constexpr double usual_knee = 0.01;

bool in_space(const ClothCase&, int dimension) { return dimension == 3; }

template <double Material::*member>
double& material(ClothCase& cloth) {
  return cloth.material.*member;
}

bool is_linear(const ClothCase& cloth, int) { return !std::isfinite(cloth.material.knee); }

/// Beyond a strain cloth may be stiffer; from there its stiffness must be given.
void check_knee(ClothCase& cloth, const Node& node, int) {
  const Node* beyond = node.find("stiffness_beyond");
  const Node* knee = node.find("knee");
  if (!beyond && knee)
    throw error_at(*knee,
                   "expected stiffness_beyond along with it, by which cloth is stretched "
                   "beyond that strain");
  if (!beyond) return;
  if (cloth.material.stretch_beyond < cloth.material.stretch)
    throw error_at(*beyond, fmt::format("allowed: from stretch_stiffness, \"{:g} N/m\", on",
                                        cloth.material.stretch));
  if (!knee) cloth.material.knee = usual_knee;
}

/// What a laboratory measures, from which other keys follow.
void add_measured(Table<ClothCase>& table) {
  table
      .key("air_permeability", &ClothCase::air_permeability, quantity(measure::speed, at_least(0)),
           "of air at 100 Pa (ISO 9237), where `permeability` is not given")
      .omitted([](const ClothCase& cloth, int) { return cloth.air_permeability == 0; })
      .key("areal_mass", &ClothCase::areal_mass, quantity(measure::areal_mass, above(0)),
           "dry mass, where `excess_mass` is not given")
      .omitted([](const ClothCase& cloth, int) { return cloth.areal_mass == 0; })
      .key("fibre_density", &ClothCase::fibre_density, quantity(measure::density, above(0)),
           "by which the fibres of `areal_mass` displace water; of cotton if not given");
}

void add_material(Table<ClothCase>& table) {
  table
      .key("stretch_stiffness", material<&Material::stretch>,
           quantity(measure::stiffness, above(0)), "K_e of Eq. (14)")
      .required()
      .key("stiffness_beyond", material<&Material::stretch_beyond>,
           quantity(measure::stiffness, above(0)),
           "the same of strains beyond `knee`: cloth is soft while its crimp is pulled out")
      .fallback("as `stretch_stiffness`")
      .omitted(is_linear)
      .key("knee", material<&Material::knee>, number(between(1e-4, 1)),
           "strain beyond which `stiffness_beyond` holds")
      .fallback("0.01 where `stiffness_beyond` is given")
      .omitted(is_linear)
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
      .fallback("from `areal_mass`, else none")
      .key("thickness", material<&Material::thickness>, quantity(measure::length, above(0)),
           "q, by which forces become stresses")
      .required()
      .key("permeability", material<&Material::permeability>,
           quantity(measure::permeability, at_least(0)),
           "lambda of Darcy's law: velocity at which water goes through, by pressure")
      .fallback("from `air_permeability`, else none")
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
  table.key("name", &ClothCase::name, label(), "of the group, in statistics, curves and colours")
      .fallback("`cloth`, of several groups `cloth 1`, `cloth 2` ...")
      .key("fabric", &ClothCase::fabric, one_of(fabric_names()),
           "gives what neither the table nor `kes` or `fast` do, in this order (the stretch keys "
           "together): see Fabrics below")
      .omitted([](const ClothCase& cloth, int) { return cloth.fabric.empty(); })
      .key("count", &ClothCase::count, integer(between(0, 100000)), "number of pieces")
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
      .key(
          "load", &ClothCase::load, formulas(measure::pressure, true),
          "force that pulls at the cloth, over its area at rest; x, y, z and r are where the cloth "
          "is")
      .omitted([](const ClothCase& cloth, int) { return cloth.load == ClothCase().load; })
      .key("arrangement", &ClothCase::arrangement,
           choice<Arrangement>({{"book", Arrangement::book},
                                {"random", Arrangement::random},
                                {"dropped", Arrangement::dropped},
                                {"layers", Arrangement::layers},
                                {"sheet", Arrangement::sheet},
                                {"ring", Arrangement::ring}}),
           "start: pages of a book about the axis, at random, the same and then "
           "sunk (see Settle), round the axis layer within layer (3-D), one sheet, or a closed "
           "ring (2-D)");
  add_material(table);
  add_measured(table);
  add_start(table);
  table.then(check_knee);
  table
      .table(
          "kes", [](ClothCase& cloth) -> KesReadings& { return *cloth.kes; }, kes_table())
      .optional([](const ClothCase& cloth) { return cloth.kes.has_value(); },
                [](ClothCase& cloth) { cloth.kes.emplace(); })
      .table(
          "fast", [](ClothCase& cloth) -> FastReadings& { return *cloth.fast; }, fast_table())
      .optional([](const ClothCase& cloth) { return cloth.fast.has_value(); },
                [](ClothCase& cloth) { cloth.fast.emplace(); });
  return table;
}

namespace {

/// Whether a piece is larger than a page of the book has room for.
bool outgrows_page(const ClothCase& cloth, const WasherSpec& washer) {
  return cloth.arrangement == Arrangement::book &&
         (cloth.inner_radius + cloth.size[0] > washer.radius ||
          cloth.bottom + cloth.size[1] > washer.depth);
}

/// Starts such a piece round the axis, folded where it has to be.
std::string use_layers(ClothCase& cloth, const WasherSpec& washer) {
  const double room[] = {std::numbers::pi * washer.radius, 0.7 * washer.depth};
  cloth.arrangement = Arrangement::layers;
  for (size_t d = 0; d < 2; ++d)
    cloth.folded[d] = std::clamp(static_cast<int>(std::ceil(cloth.size[d] / room[d])), 1, 8);
  return fmt::format(
      "{}: pieces of {:.3g} x {:.3g} m are larger than a page about the axis may be, and start "
      "round it in layers, folded into {} x {} (cloth.arrangement, cloth.folded)",
      cloth.name, cloth.size[0], cloth.size[1], cloth.folded[0], cloth.folded[1]);
}

}  // namespace

void complete_cloth(CaseFile& file, const Node& root, int dimension) {
  auto& groups = file.result.cloth;
  const FluidCase& fluid = file.result.fluid;
  for (size_t i = 0; i < groups.size(); ++i) {
    ClothCase& cloth = groups[i];
    const auto given = [&](const std::string& key) {
      return find_key(root, cloth_key(i, groups.size(), key)) != nullptr;
    };
    if (cloth.name.empty())
      cloth.name = groups.size() > 1 ? fmt::format("cloth {}", i + 1) : "cloth";
    if (cloth.areal_mass > 0 && !given("excess_mass"))
      cloth.material.excess_mass =
          cloth.areal_mass * std::max(0.0, 1 - fluid.density / cloth.fibre_density);
    static constexpr const char* starts[] = {"arrangement", "folded", "crumpled", "inner_radius",
                                             "bottom",      "shift",  "tilt"};
    const bool open = std::none_of(std::begin(starts), std::end(starts), given);
    if (file.washer && dimension == 3 && open && outgrows_page(cloth, *file.washer))
      file.result.notes.push_back(use_layers(cloth, *file.washer));
    if (!given("permeability"))
      cloth.material.permeability = cloth.air_permeability / 100 * air_viscosity / fluid.viscosity;
  }
}

std::string cloth_key(size_t i, size_t total, const std::string& name) {
  return total > 1 ? fmt::format("cloth[{}].{}", i + 1, name) : "cloth." + name;
}

bool is_held(const std::vector<Edge>& held, int direction, int end) {
  return std::count(held.begin(), held.end(), static_cast<Edge>(2 * direction + end)) > 0;
}

double start_extent(const ClothCase& cloth, int direction) {
  const auto d = static_cast<size_t>(direction);
  return cloth.size[d] / cloth.folded[d] * (1 - cloth.crumpled);
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
