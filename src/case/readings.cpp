#include "case/readings.hpp"

#include <cmath>

namespace washtub {
namespace {

constexpr double gravity = 9.80665;
constexpr double gf_per_cm = 1e-3 * gravity / 1e-2;                // [N/m]
constexpr double bending_unit = 1e-3 * gravity * 1e-4 / 1e-2;      // gf cm^2/cm [N m]
constexpr double shear_unit = gf_per_cm * 180 / 3.14159265358979;  // gf/(cm deg) [N/m]

using Values = std::vector<std::pair<std::string, Node>>;

void add(Values& values, const char* key, double value, const char* unit) {
  values.emplace_back(key, Node{fmt::format("{:.6g} {}", value, unit), "", ""});
}

/// Two straight lines for N = N_m (e/e_m)^(2/LT - 1), whose work up to N_m at e_m = EMT is
/// LT N_m e_m/2: its secants below and above a fifth of e_m; where it does not stiffen, one.
void add_stretch(Values& values, const KesReadings& kes) {
  const double most = 500 * gf_per_cm, longest = kes.EMT / 100;
  if (kes.LT >= 1) return add(values, "stretch_stiffness", most / longest, "N/m");
  const double knee = longest / 5, tension = most * std::pow(0.2, 2 / kes.LT - 1);
  add(values, "stretch_stiffness", tension / knee, "N/m");
  add(values, "stiffness_beyond", (most - tension) / (longest - knee), "N/m");
  values.emplace_back("knee", Node{knee, "", ""});
}

void add_bending(Values& values, double bending, int dimension) {
  add(values, "bending_stiffness", bending, "N m");
  if (dimension == 3) add(values, "torsion_stiffness", bending, "N m");
}

void add_kes(Values& values, const Node& node, int dimension) {
  KesReadings kes;
  kes_table().read(kes, node, dimension);
  add_stretch(values, kes);
  if (dimension == 3) add(values, "shear_stiffness", kes.G * shear_unit, "N/m");
  add_bending(values, kes.B * bending_unit, dimension);
}

void add_fast(Values& values, const Node& node, int dimension) {
  FastReadings fast;
  fast_table().read(fast, node, dimension);
  if (fast.E20 <= fast.E5)
    throw error_at(*node.find("E20"), fmt::format("allowed: above E5, which is {:g}", fast.E5));
  add(values, "areal_mass", 1e-3 * fast.W, "kg/m^2");
  add(values, "stretch_stiffness", 15 * gf_per_cm / (1e-2 * (fast.E20 - fast.E5)), "N/m");
  if (dimension == 3) add(values, "shear_stiffness", 123 / fast.EB5, "N/m");
  const double length = 1e-3 * fast.C;
  add_bending(values, 1e-3 * fast.W * gravity * length * length * length, dimension);
}

}  // namespace

Table<KesReadings> kes_table() {
  Table<KesReadings> table(
      "Readings of Kawabata's instruments (KES-F), means of warp and weft in their usual units, "
      "from which bending, torsion, shear and stretch (two chords of N = 490 N/m (e/EMT)^(2/LT - "
      "1), which meet at a fifth of EMT) follow where the file does not give them.");
  table.key("B", &KesReadings::B, number(between(1e-3, 10)), "bending rigidity [gf cm^2/cm]")
      .required()
      .key("G", &KesReadings::G, number(between(1e-2, 20)), "shear stiffness [gf/(cm deg)]")
      .required()
      .key("LT", &KesReadings::LT, number(between(0.3, 1.2)), "linearity of the tensile curve")
      .required()
      .key("EMT", &KesReadings::EMT, number(between(0.2, 100)), "extension at 500 gf/cm [%]")
      .required();
  return table;
}

Table<FastReadings> fast_table() {
  Table<FastReadings> table(
      "Readings of FAST, means of warp and weft in their usual units, from which mass, bending, "
      "torsion, shear and stretch (the secant from 5 to 20 gf/cm) follow where the file does not "
      "give them.");
  table.key("W", &FastReadings::W, number(between(10, 2000)), "mass [g/m^2]")
      .required()
      .key("C", &FastReadings::C, number(between(1, 100)), "bending length [mm]")
      .required()
      .key("E5", &FastReadings::E5, number(between(0, 50)), "extension at 5 gf/cm [%]")
      .required()
      .key("E20", &FastReadings::E20, number(between(0.05, 50)), "extension at 20 gf/cm [%]")
      .required()
      .key("EB5", &FastReadings::EB5, number(between(0.2, 50)),
           "extension on the bias at 5 gf/cm [%]")
      .required();
  return table;
}

std::vector<std::pair<std::string, Node>> read_readings(const Node& cloth, int dimension) {
  Values values;
  if (const Node* kes = cloth.find("kes")) add_kes(values, *kes, dimension);
  if (const Node* fast = cloth.find("fast")) add_fast(values, *fast, dimension);
  return values;
}

}  // namespace washtub
