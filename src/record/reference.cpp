#include "record/reference.hpp"

#include <fmt/format.h>

#include "record/columns.hpp"
#include "record/field_list.hpp"
#include "record/quantities.hpp"
#include "record/summarise.hpp"

namespace washtub {
namespace {

constexpr const char* head = R"(# Output reference

Made by `washtub reference --output`; do not edit.

A run writes into its directory: `case.toml` (the case, complete), `history.csv`, `tracks.csv`
(where there is cloth), `frames/`, `summary.json`, `log.txt` and `report.html`. Units are SI, angles
in radians. Forces, torques, energies and powers of a plane case are per metre of its depth, and so
are their units: N m/m where a case in space has N m.

No file holds a NaN or an infinity: in a CSV file the field is empty, in a JSON file the value is
`null`; a frame whose water is not finite everywhere is not written, and the run stops and says so.
)";

std::string unit_text(const Unit& unit) {
  const std::string space = unit.in(3), plane = unit.in(2);
  return space == plane ? space : fmt::format("{} ({} in 2-D)", space, plane);
}

std::string when_text(When when) {
  switch (when) {
    case When::moving:
      return " (only of solids that turn)";
    case When::space:
      return " (only in 3-D)";
    case When::always:
      break;
  }
  return "";
}

/// A page under way.
class Page {
 public:
  void section(const std::string& heading, const std::string& meaning) {
    text += fmt::format("\n## {}\n\n{}\n", heading, meaning);
  }
  /// A list of declarations; their names follow `owner`.
  template <class Declarations>
  void table(const std::string& meaning, const Declarations& declared,
             const std::string& owner = "") {
    if (!meaning.empty()) text += fmt::format("\n{}\n", meaning);
    text += "\n| name | unit | meaning |\n|---|---|---|\n";
    for (const auto& one : declared) {
      const Declared& about = one.about;
      text += fmt::format("| `{}{}` | {} | {}{} |\n", owner, about.name, unit_text(about.unit),
                          about.meaning, when_text(about.when));
    }
  }
  std::string text = head;
};

void add_history(Page& page) {
  page.section("history.csv",
               "One row every `output.every`: a header \"time [s],step,...\" with the units, then "
               "numbers, the time with all its digits, the others with nine.");
  page.table("", columns::run);
  page.table("Where no water passes the sides:", columns::energy);
  page.table("Of each solid, after its name:", columns::solid, "SOLID ");
  page.table("With `[exact]`; pure numbers where it is relative:", columns::error);
  page.table("With cloth:", columns::cloth);
  page.table("Of each group of cloth, after its name, where there are several:", columns::group,
             "GROUP ");
  page.table("Of each probe, after its name:", columns::probe, "PROBE ");
  page.table("With rings:", columns::rings);
}

void add_tracks(Page& page) {
  page.section("tracks.csv", "The pieces of cloth, in the same rows. First the column `time [s]`.");
  page.table("Of each piece, counted from 1:", columns::piece, "piece N ");
}

std::string field_rows(const std::vector<FieldDescription>& declared, const std::string& group) {
  std::string rows = "\n| dataset | in ParaView | unit | meaning |\n|---|---|---|---|\n";
  for (const FieldDescription& field : declared)
    rows += fmt::format("| `{}/{}` | {} | {} | {}{} |\n", group, field.name, field.label,
                        field.unit, field.meaning, field.components > 1 ? "; a vector" : "");
  return rows;
}

void add_frames(Page& page) {
  page.section(
      "frames/frame_000000.h5",
      "One HDF5 file every `output.frames`; `frames.xdmf` lists them for ParaView, which opens "
      "`paraview.xdmf2` ([paraview.md](paraview.md)). Attributes of the file are `time [s]` and "
      "`angle of SOLID [rad]`, with cloth `edges of cloth`, `edges through other pieces` and "
      "`edges "
      "through their own piece`; each field has its unit, label and meaning as attributes. Of the "
      "water, per cell, x fastest, in 32 bits:");
  page.text += field_rows(water_field_list(), "fluid");
  page.text +=
      "\nOf the cloth, per node, all pieces one after the other, beside `cloth/positions` [m], "
      "`cloth/cells` (nodes of each cell), `cloth/piece` (of each cell) and `cloth/pieces` (first "
      "node and extent of each piece):\n";
  page.text += field_rows(cloth_field_list(), "cloth");
}

void add_summary(Page& page) {
  page.section(
      "summary.json",
      "Written at the end, also of a run that was stopped or has failed. Units stand in the names, "
      "\"wall time [s]\". Statistics rest on the whole cycles of the drive within `output.window`, "
      "so those of the report are the same numbers; `statistics over [s]` tells the span.");
  page.table("", entries::top);
  page.table("`run`:", entries::run);
  page.table(
      "`phases`, where the time of the first rank went since the run was started or went on, "
      "waiting for other ranks and for the disk included:",
      entries::phases);
  page.table("`coupling`, with cloth, over all steps of the run:", entries::coupling);
  page.table(
      "`quality`, over all rows of the history and all frames; beside it stands `warnings`, "
      "a list of sentences on what is not as it should be:",
      entries::quality);
  page.table("`scales`, where the case has a speed:", entries::scales);
  page.table(
      "`solids`, one table for each with its `name`. Torques also over tau_o (`rms torque / "
      "tau_o`); `energy per cycle` is a list with each whole cycle, beside it stand `mean "
      "energy per cycle` and `energy per cycle, 95 % half width`:",
      quantities_of::solid);
  page.table("`cloth`:", entries::cloth);
  page.table("`cloth`: `stress`, `membrane stress` and `bending stress`, each with:",
             entries::stress);
  page.table("`cloth`: `loop`, in 3-D, how the pieces' centres go round in (r, z):", entries::loop);
}

}  // namespace

std::string output_reference() {
  Page page;
  add_history(page);
  add_tracks(page);
  add_frames(page);
  add_summary(page);
  page.section("The report",
               "`report.html` and `washtub compare` show these statistics, after the names of the "
               "solids, and the scatter of `summary.json`.");
  page.table("Of the cloth:", quantities_of::cloth);
  return page.text;
}

}  // namespace washtub
