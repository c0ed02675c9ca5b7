#include "case/case.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "case/fabrics.hpp"
#include "case/tables.hpp"

namespace washtub {
namespace {

Format<int> dimension_format() {
  return {[](const Node& node, int) {
            const int value = integer().read(node, 3);
            if (value != 2 && value != 3) throw error_at(node, "allowed: 2 or 3");
            return value;
          },
          [](int value, int) { return std::to_string(value); }, "integer", "2 or 3",
          json_schema::integer(between(2, 3))};
}

/// What the washer fills in before the tables below it are read over it.
void use_washer(CaseFile& file, const Node& root, int dimension) {
  if (!file.washer) return;
  complete(*file.washer, dimension);
  check_washer(*file.washer, root, dimension);
  fill_case(file.result, *file.washer);
}

ClothCase new_cloth(const CaseFile& file) {
  if (file.washer) return default_cloth(*file.washer, file.result.dimension);
  ClothCase cloth;
  cloth.arrangement = file.result.dimension == 3 ? Arrangement::book : Arrangement::random;
  return cloth;
}

/// Builds the solids of the file; one with the name of a solid of the washer replaces it.
void add_solids(CaseFile& file, const Node&, int dimension) {
  auto& solids = file.result.solids;
  for (const SolidSpec& spec : file.solids) {
    SolidCase solid;
    solid.name = spec.name;
    solid.shape = shape_kinds().make(spec.shape, dimension);
    if (spec.angle != 0) solid.shape = rotate_z(solid.shape, spec.angle);
    solid.centre = spec.centre;
    solid.drive = drive_kinds().make(spec.drive, dimension);
    std::erase_if(solids, [&](const SolidCase& other) { return other.name == spec.name; });
    solids.push_back(std::move(solid));
  }
}

double fastest_drive(const Case& whole) {
  double peak = 0;
  for (const SolidCase& solid : whole.solids) peak = std::max(peak, solid.drive.peak());
  return peak;
}

/// Scales where neither the file nor the washer gives them.
void set_scales(CaseFile& file, const Node&, int dimension) {
  Case& whole = file.result;
  ScaleCase& scale = whole.scale;
  double wall = 0;
  for (const SideCase& side : whole.domain.sides) wall = std::max(wall, side.velocity.norm());
  if (scale.length == 0) scale.length = whole.domain.size.x() / 2;
  if (scale.height == 0) scale.height = dimension == 3 ? whole.domain.size.z() : 1;
  scale.speed = fastest_drive(whole);
  if (scale.speed == 0) scale.speed = wall / scale.length;
  for (const SolidCase& solid : whole.solids)
    scale.period = std::max(scale.period, solid.drive.period());
}

/// Step, sample interval, window and contact where the file does not give them.
void set_times(CaseFile& file, const Node& root, int) {
  Case& whole = file.result;
  const double peak = fastest_drive(whole);
  if (whole.time.step == 0 && peak > 0) whole.time.step = std::min(5e-3 / peak, largest_quantity);
  if (whole.output.every == 0)
    whole.output.every = (whole.scale.period > 0 ? whole.scale.period : whole.time.end) / 200;
  if (!find_key(root, "output.window")) whole.output.window_end = whole.time.end;
  whole.contact = complete_contact(whole);
}

template <auto member>
auto part() {
  return [](CaseFile & file) -> auto& { return file.result.*member; };
}

Table<CaseFile> declare() {
  Table<CaseFile> table(
      "A case file is TOML. Physical quantities are texts with their units: `\"120 rpm\"`, "
      "`\"15 cm\"`.");
  table.key("title", part<&Case::title>(), text(), "shown in reports")
      .key("dimension", part<&Case::dimension>(), dimension_format(), "dimension of space")
      .table(
          "washer", [](CaseFile& file) -> WasherSpec& { return *file.washer; }, washer_table())
      .optional([](const CaseFile& file) { return file.washer.has_value(); },
                [](CaseFile& file) { file.washer.emplace(); })
      .then(use_washer)
      .table("fluid", part<&Case::fluid>(), fluid_table())
      .table("domain", part<&Case::domain>(), domain_table())
      .list("solid", &CaseFile::solids, solid_table(), [](const CaseFile&) { return SolidSpec(); })
      .then(add_solids)
      .list("cloth", part<&Case::cloth>(), cloth_table(), new_cloth)
      .then(complete_cloth)
      .list("probe", part<&Case::probes>(), probe_table(),
            [](const CaseFile&) { return ProbeCase(); })
      .table(
          "exact", [](CaseFile& file) -> ExactCase& { return *file.result.exact; }, exact_table())
      .optional([](const CaseFile& file) { return file.result.exact.has_value(); },
                [](CaseFile& file) { file.result.exact.emplace(); })
      .table("coupling", part<&Case::coupling>(), coupling_table())
      .table("contact", part<&Case::contact>(), contact_table())
      .table("settle", part<&Case::settle>(), settle_table())
      .then(complete_settle)
      .table("time", part<&Case::time>(), time_table())
      .table("solver", part<&Case::solver>(), solver_table())
      .table("output", part<&Case::output>(), output_table())
      .table("checkpoint", part<&Case::checkpoint>(), checkpoint_table())
      .then(set_scales)
      .table("scale", part<&Case::scale>(), scale_table())
      .then(set_times)
      .then(fit_output)
      .then(note_jumps);
  return table;
}

/// What was changed, as the title does not know it: " (changed: cloth.count=8)".
std::string changes(const std::vector<std::string>& settings) {
  return settings.empty() ? "" : fmt::format(" (changed: {})", fmt::join(settings, ", "));
}

/// The dimension decides how other keys are read, so it is read first.
int read_dimension(const Node& root) {
  const Node* node = root.find("dimension");
  return node ? dimension_format().read(*node, 3) : Case().dimension;
}

Case read_root(Node root, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) apply_setting(root, setting);
  check_known(root, case_table().names());
  const int dimension = read_dimension(root);
  use_fabrics(root, dimension);
  CaseFile file;
  case_table().read(file, root, dimension);
  check_case(file, root);
  const Node* title = root.find("title");
  if (title && title->where != "--set") file.result.title += changes(settings);
  case_table().write(file.result.resolved, file, "", dimension);
  return std::move(file.result);
}

}  // namespace

const Table<CaseFile>& case_table() {
  static const Table<CaseFile> table = declare();
  return table;
}

Case read_case(const std::string& path, const std::vector<std::string>& settings) {
  return read_root(parse_file(path), settings);
}

Case read_case_text(const std::string& text, const std::string& name,
                    const std::vector<std::string>& settings) {
  return read_root(parse_text(text, name), settings);
}

std::string input_reference() {
  std::string out =
      "# Input reference\n\nMade by `washtub reference`; do not edit.\n\n"
      "The same as a JSON schema, by which editors complete and check case files: write it with "
      "`washtub reference --schema > washtub.schema.json`, and let a case begin with the line "
      "`#:schema ./washtub.schema.json`. Taplo and Even Better TOML (an extension of Visual Studio "
      "Code) follow that; `taplo lint case.toml` checks without an editor. What a schema cannot "
      "say, such as a bound of a quantity with its unit, is left to `washtub check`.\n";
  case_table().document(out, "");
  out += "\n## Fabrics\n\n" + fabric_reference();
  drive_kinds().document(out);
  shape_kinds().document(out);
  return out;
}

std::string case_schema() {
  return json_schema::document(case_table().schema(),
                               {drive_kinds().definition(), shape_kinds().definition()});
}

}  // namespace washtub
