#include "report/statistics.hpp"

#include <array>

#include "record/columns.hpp"
#include "record/names.hpp"

namespace washtub {

using Json = nlohmann::ordered_json;

namespace {

/// Those that a page shows; their names follow that of their owner.
void add(std::vector<RunQuantity>& found, std::vector<RunQuantity> more,
         const std::string& owner = "") {
  for (RunQuantity& quantity : more) {
    if (!quantity.on_page) continue;
    if (!owner.empty()) quantity.name = owner + ' ' + quantity.name;
    found.push_back(std::move(quantity));
  }
}

/// The scatter needs all points of the cloth at all samples, which only the run itself has.
void add_scatter(std::vector<RunQuantity>& found, const RunRecord& run) {
  const std::array<std::array<const char*, 2>, 2> scatters = {
      {{names::common_scatter, names::common_scatter_cycles},
       {names::own_scatter, names::own_scatter_cycles}}};
  for (const auto& [name, cycles] : scatters) {
    RunQuantity quantity{name, metre.name, 0, {}, "", 1};
    if (run.definition) quantity.scale_name = "r_o", quantity.scale = run.definition->scale.length;
    const auto unit = [](const char* entry) { return std::string(entry) + " [m]"; };
    const auto mean = summary_number(run, {names::cloth, unit(name)});
    if (!mean) continue;
    quantity.batches = summary_numbers(run, {names::cloth, unit(cycles)});
    quantity.mean = *mean;
    found.push_back(std::move(quantity));
  }
}

}  // namespace

std::vector<RunQuantity> find_quantities(const RunRecord& run) {
  std::vector<RunQuantity> found;
  if (run.definition && run.history && run.history->rows() > 1) {
    const Case& whole = *run.definition;
    if (!whole.cloth.empty()) add(found, cloth_quantities(whole, *run.history));
    for (const ClothCase& group : groups_apart(whole))
      add(found, group_quantities(whole, group, *run.history), group.name);
    for (const SolidCase& solid : whole.solids)
      add(found, solid_quantities(whole, solid, *run.history), solid.name);
  }
  add_scatter(found, run);
  return found;
}

Json to_json(const RunQuantity& quantity) {
  const auto width = quantity.half_width();
  const auto optional = [](std::optional<double> value) { return value ? Json(*value) : Json(); };
  Json json = {{"name", quantity.name},
               {"unit", quantity.unit},
               {"meaning", quantity.meaning},
               {"mean", quantity.mean},
               {"half_width", optional(width)},
               {"batches", quantity.batches.size()},
               {"scaled", nullptr}};
  if (quantity.scale_name.empty()) return json;
  json["scaled"] = {{"mean", quantity.mean / quantity.scale},
                    {"half_width", width ? Json(*width / quantity.scale) : Json()},
                    {"by", quantity.scale_name}};
  return json;
}

Json quantities(const RunRecord& run) {
  Json list = Json::array();
  for (const RunQuantity& quantity : find_quantities(run)) list.push_back(to_json(quantity));
  return list;
}

}  // namespace washtub
