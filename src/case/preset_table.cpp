#include "case/preset.hpp"
#include "case/tables.hpp"

namespace washtub {
namespace {

using Spec = Agitator3d;

/// A length of the agitator whose default is in proportion to the tub.
Table<Spec>& length(Table<Spec>& table, const std::string& name, double Spec::*member,
                    const std::string& proportion, const std::string& meaning) {
  return table.key(name, member, quantity(measure::length, above(0)), meaning).fallback(proportion);
}

/// The same, where a 2-D washer has none.
void height(Table<Spec>& table, const std::string& name, double Spec::*member,
            const std::string& proportion, const std::string& meaning) {
  length(table, name, member, proportion, meaning).only("in 3-D", [](const Spec&, int dimension) {
    return dimension == 3;
  });
}

Table<Spec> agitator_table() {
  Table<Spec> table(
      "The agitator: a conical skirt, a hub with a round cap and upright fins, on the tub's "
      "bottom; in 2-D a round hub with straight, round-ended fins. Lengths default to proportions "
      "of the tub radius r and the water depth H.");
  height(table, "rim_radius", &Spec::rim_radius, "0.70 r", "radius of the skirt's rim");
  height(table, "rim_height", &Spec::rim_height, "0.04 H", "height of the skirt at its rim");
  height(table, "skirt_top_radius", &Spec::skirt_top_radius, "0.12 r", "where its slope ends");
  height(table, "skirt_top_height", &Spec::skirt_top_height, "0.70 H", "where its slope ends");
  length(table, "hub_radius", &Spec::hub_radius, "0.12 r (0.16 r in 2-D)", "radius of the hub");
  height(table, "hub_height", &Spec::hub_height, "0.75 H", "height of the hub below its cap");
  table.key("fins", &Spec::fins, integer(between(0, 24)), "number of fins").fallback("`3`");
  length(table, "fin_radius", &Spec::fin_radius, "0.45 r (0.62 r in 2-D)",
         "from the axis to the fin's end");
  length(table, "fin_half_thickness", &Spec::fin_half_thickness, "0.035 r",
         "half the thickness of a fin");
  height(table, "fin_root_height", &Spec::fin_root_height, "0.75 H", "fin's top edge at the hub");
  height(table, "fin_tip_height", &Spec::fin_tip_height, "0.45 H", "fin's top edge at its end");
  return table;
}

struct Check {
  const char* name;
  double value;
  double limit;
  const char* limit_name;
};

/// Throws at the key where its value is not below the limit.
void check_below(const Node& root, const std::string& fault, const Check& check) {
  if (check.value < check.limit) return;
  const std::string key = std::string("washer.agitator.") + check.name;
  throw error_at_key(
      root, key, metres(check.value),
      fmt::format("{}, allowed: below {:.6g} m ({})", fault, check.limit, check.limit_name));
}

void check_widths(const WasherSpec& washer, const Node& root, int dimension) {
  const Spec& agitator = washer.agitator;
  const std::string fault = "the agitator is wider than the tub";
  const double cap = dimension == 2 ? agitator.fin_half_thickness : 0;
  if (dimension == 3)
    check_below(root, fault, {"rim_radius", agitator.rim_radius, washer.radius, "washer.radius"});
  check_below(root, fault, {"hub_radius", agitator.hub_radius, washer.radius, "washer.radius"});
  if (agitator.fins == 0) return;
  check_below(root, fault,
              {"fin_radius", agitator.fin_radius, washer.radius - cap,
               cap > 0 ? "washer.radius less the fin's round end" : "washer.radius"});
  check_below(root, "the fins end inside the hub",
              {"hub_radius", agitator.hub_radius, agitator.fin_radius, "fin_radius"});
}

void check_heights(const WasherSpec& washer, const Node& root) {
  const Spec& agitator = washer.agitator;
  check_below(root, "the skirt widens upwards",
              {"skirt_top_radius", agitator.skirt_top_radius, agitator.rim_radius, "rim_radius"});
  const double under_cap = washer.depth - agitator.hub_radius;
  for (const Check& check :
       {Check{"hub_height", agitator.hub_height, under_cap, "washer.depth less the round cap"},
        Check{"rim_height", agitator.rim_height, washer.depth, "washer.depth"},
        Check{"skirt_top_height", agitator.skirt_top_height, washer.depth, "washer.depth"},
        Check{"fin_root_height", agitator.fin_root_height, washer.depth, "washer.depth"},
        Check{"fin_tip_height", agitator.fin_tip_height, washer.depth, "washer.depth"}})
    check_below(root, "the agitator is higher than the water", check);
}

}  // namespace

void check_washer(const WasherSpec& washer, const Node& root, int dimension) {
  check_widths(washer, root, dimension);
  if (dimension == 3) check_heights(washer, root);
}

Table<WasherSpec> washer_table() {
  Table<WasherSpec> table(
      "A vertical-axis washer from a designer's few numbers. Fills in the box, the solids \"tub\" "
      "and \"agitator\", the scales and where cloth starts; keys given elsewhere win over it. The "
      "axis is x = y = 0, the bottom no-slip, the water's surface flat and free of friction.");
  table.key("radius", &WasherSpec::radius, quantity(measure::length, above(0)), "radius of the tub")
      .required()
      .key("depth", &WasherSpec::depth, quantity(measure::length, above(0)), "depth of the water")
      .required()
      .only("in 3-D", [](const WasherSpec&, int dimension) { return dimension == 3; })
      .key("stroke", &WasherSpec::stroke, drive_kinds().format(paper_stroke()),
           "how the agitator turns")
      .table("agitator", &WasherSpec::agitator, agitator_table());
  return table;
}

}  // namespace washtub
