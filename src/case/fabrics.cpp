#include "case/fabrics.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/format.hpp"
#include "case/readings.hpp"

namespace washtub {
namespace {

constexpr const char* typical = "typical";
constexpr const char* wang = "Wang, O'Brien & Ramamoorthi 2011, as tabulated with ARCSim";
constexpr const char* denims = "KES of six denims, Journal of Textiles 2016, 4614168";
constexpr const char* denim_law = "secants below and above 1 % of the mean KES of six denims";
constexpr const char* as_denim = "typical, four times as stiff beyond 1 %, as denim is";
constexpr const char* energy = "10 CFR 430 B, appendix J: 5.60 oz/yd^2";
constexpr const char* blend = "of its fibres: cotton 1540 kg/m^3, polyester 1380 kg/m^3";

/// A number and its source.
struct Value {
  double number;
  const char* source = typical;
};

/// A row of the library, in the units of its keys.
struct Row {
  const char* name;
  Value areal_mass;     ///< dry [kg/m^2]
  Value fibre_density;  ///< [kg/m^3]
  Value thickness;      ///< [mm]
  Value stretch;        ///< at small strain, or where it is not known near 20 N/m [N/m]
  Value beyond;         ///< of strains above 0.01 [N/m]; 0: as `stretch`
  Value shear;          ///< [N/m]
  Value bending;        ///< [uN m]
  Value air;            ///< at 100 Pa [mm/s]
  Value friction;       ///< wet
};

const Row rows[] = {
    {"energy test cloth",
     {0.190, energy},
     {1456, blend},
     {0.5},
     {2000, "derived, near 20 N/m"},
     {8000, as_denim},
     {60},
     {15},
     {150},
     {0.5}},
    {"cotton sheet",
     {0.150},
     {1540, blend},
     {0.35},
     {3000},
     {12000, as_denim},
     {60},
     {10},
     {150},
     {0.8}},
    {"t-shirt jersey",
     {0.187, wang},
     {1472, blend},
     {0.6},
     {300, wang},
     {0},
     {30},
     {20, wang},
     {700},
     {0.8}},
    {"rib underwear",
     {0.276, wang},
     {1540, blend},
     {0.9},
     {150, wang},
     {0},
     {30},
     {60, wang},
     {600},
     {0.8}},
    {"terry towel",
     {0.450, typical},
     {1540, blend},
     {3},
     {1500},
     {6000, as_denim},
     {40},
     {60},
     {300},
     {0.85}},
    {"polyester shirt",
     {0.113, wang},
     {1380, blend},
     {0.25},
     {400, wang},
     {1600, as_denim},
     {40},
     {15, wang},
     {80},
     {0.35}},
    {"denim",
     {0.324, wang},
     {1540, blend},
     {0.95, denims},
     {2600, denim_law},
     {11000, denim_law},
     {100, denims},
     {20, denims},
     {40},
     {0.7}},
    {"trousers",
     {0.220, wang},
     {1480, blend},
     {0.5},
     {2100, wang},
     {8400, as_denim},
     {70},
     {150, wang},
     {80},
     {0.6}},
};

Node text_node(const std::string& text) { return {text, "", ""}; }

Fabric fabric_of(const Row& row) {
  Fabric fabric{row.name, {}};
  const auto quantity = [&](const char* key, const Value& value, const char* unit) {
    fabric.values.push_back(
        {key, text_node(fmt::format("{:g} {}", value.number, unit)), value.source});
  };
  const auto number = [&](const char* key, const Value& value) {
    fabric.values.push_back({key, {value.number, "", ""}, value.source});
  };
  quantity("areal_mass", row.areal_mass, "kg/m^2");
  quantity("fibre_density", row.fibre_density, "kg/m^3");
  quantity("thickness", row.thickness, "mm");
  quantity("stretch_stiffness", row.stretch, "N/m");
  if (row.beyond.number > 0) quantity("stiffness_beyond", row.beyond, "N/m");
  quantity("shear_stiffness", row.shear, "N/m");
  quantity("bending_stiffness", {row.bending.number * 1e-6, row.bending.source}, "N m");
  quantity("torsion_stiffness", {row.bending.number * 1e-6, "as bending"}, "N m");
  quantity("air_permeability", row.air, "mm/s");
  quantity("loss_time", {2}, "ms");
  number("friction", row.friction);
  number("solid_friction", {0.2});
  return fabric;
}

bool in_plane(const std::string& key) {
  return key != "shear_stiffness" && key != "torsion_stiffness";
}

/// Keys that only go together.
bool of_stretch(const std::string& key) {
  return key == "stretch_stiffness" || key == "stiffness_beyond" || key == "knee";
}

/// Adds a member to a table that has none of that name.
void fill(Node& table, const std::string& key, Node value, const std::string& where) {
  if (table.find(key)) return;
  value.where = where;
  value.key = table.key + "." + key;
  table.members().push_back({key, std::move(value)});
}

void fill_cloth(Node& cloth, int dimension) {
  if (!cloth.is_table()) return;
  bool stretch_given = cloth.find("stretch_stiffness") != nullptr;
  for (const auto& [key, value] : read_readings(cloth, dimension))
    if (!stretch_given || !of_stretch(key)) fill(cloth, key, value, cloth.where);
  const Node* name = cloth.find("fabric");
  if (!name) return;
  const Fabric& fabric =
      fabrics()[static_cast<std::size_t>(name_of(fabric_names()).read(*name, dimension))];
  stretch_given = cloth.find("stretch_stiffness") != nullptr;
  const std::string where = fmt::format("{} (fabric \"{}\")", name->where, fabric.name);
  for (const FabricValue& v : fabric.values)
    if ((dimension == 3 || in_plane(v.key)) && !(stretch_given && of_stretch(v.key)))
      fill(cloth, v.key, v.value, where);
}

}  // namespace

std::string Fabric::text(const std::string& key) const {
  for (const FabricValue& v : values)
    if (v.key == key) return value_text(v.value);
  return "";
}

const std::vector<Fabric>& fabrics() {
  static const std::vector<Fabric> all = [] {
    std::vector<Fabric> list;
    for (const Row& row : rows) list.push_back(fabric_of(row));
    return list;
  }();
  return all;
}

std::vector<std::string> fabric_names() {
  std::vector<std::string> names;
  for (const Fabric& fabric : fabrics()) names.push_back(fabric.name);
  return names;
}

std::string fabric_reference() {
  static constexpr const char* keys[] = {"areal_mass",       "thickness",       "stretch_stiffness",
                                         "stiffness_beyond", "shear_stiffness", "bending_stiffness",
                                         "air_permeability", "friction"};
  std::string out = fmt::format("| fabric | {} |\n|---|{}|\n", fmt::join(keys, " | "),
                                fmt::join(std::vector<std::string>(std::size(keys), "---"), "|"));
  for (const Fabric& fabric : fabrics()) {
    out += "| " + fabric.name;
    for (const char* key : keys) {
      std::string text = fabric.text(key);
      std::erase(text, '"');
      out += " | " + text;
    }
    out += " |\n";
  }
  return out;
}

std::string fabric_text(const Fabric& fabric) {
  std::string out = fmt::format("# {}\n", fabric.name);
  for (const FabricValue& v : fabric.values)
    out += fmt::format("{:<38}# {}\n", v.key + " = " + value_text(v.value), v.source);
  return out;
}

void use_fabrics(Node& root, int dimension) {
  Node* cloth = root.find("cloth");
  if (!cloth) return;
  if (!cloth->is_list()) return fill_cloth(*cloth, dimension);
  for (Node& entry : cloth->list()) fill_cloth(entry, dimension);
}

}  // namespace washtub
