#include "report/run_record.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.hpp"
#include "io/file.hpp"
#include "record/declared.hpp"
#include "record/names.hpp"

namespace washtub {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// @throws InputError where it is no directory or holds nothing of a run
void check_directory(const std::string& directory) {
  std::error_code error;
  const fs::path path(directory);
  if (!fs::exists(path, error))
    throw InputError(fmt::format("{}: no such directory; washtub run -o {} CASE makes one",
                                 directory, directory));
  if (!fs::is_directory(path, error))
    throw InputError(
        fmt::format("{}: is no directory; name the one that holds the results", directory));
  const bool empty = fs::is_empty(path, error);
  if (error) throw InputError(fmt::format("{}: cannot be read: {}", directory, error.message()));
  if (empty) throw InputError(fmt::format("{}: is empty; it has no results of a run", directory));
  for (const char* name : {"history.csv", "summary.json", "frames"})
    if (fs::exists(path / name, error)) return;
  if (fs::exists(path / "case.toml", error))
    throw InputError(
        fmt::format("{}: has a case but no results; washtub run {} writes them to a directory",
                    directory, (path / "case.toml").string()));
  throw InputError(
      fmt::format("{}: holds none of case.toml, history.csv and frames; name the directory that "
                  "washtub run has written",
                  directory));
}

std::string last_part(const std::string& directory) {
  const fs::path path = fs::absolute(directory).lexically_normal();
  const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
  return name.empty() ? directory : name;
}

/// The text of a file, "" where there is none: then a sentence says what keeps it from being read,
/// `absent` where it is not there. No sentence where that is "".
std::string text_of(RunRecord& run, const char* name, const std::string& absent) {
  const fs::path path = fs::path(run.directory) / name;
  std::error_code error;
  if (!fs::exists(path, error) && !error) {
    if (!absent.empty()) run.missing.push_back(absent);
    return "";
  }
  std::string text;
  try {
    text = read_file(path.string());
    if (text.empty()) run.missing.push_back(fmt::format("{} is empty.", name));
  } catch (const InputError& problem) {
    run.missing.push_back(fmt::format("{} cannot be read: {}.", name, problem.what()));
  }
  return text;
}

void read_definition(RunRecord& run) {
  run.case_text = text_of(
      run, "case.toml",
      "There is no case.toml: the grid, the drive, the scales and the solids are not known.");
  if (run.case_text.empty()) return;
  try {
    run.definition = read_case((fs::path(run.directory) / "case.toml").string());
  } catch (const std::exception& problem) {
    run.missing.push_back(fmt::format(
        "This program does not understand case.toml, which may be of another version: {}.",
        problem.what()));
  }
}

/// What lies deeper in a summary than anything of ours is left out.
bool is_shallow(int depth, Json::parse_event_t, Json&) { return depth < 16; }

void read_summary(RunRecord& run) {
  const std::string text =
      text_of(run, "summary.json",
              "There is no summary.json: the run is still going on, or it was ended from outside.");
  if (text.empty()) return;
  Json summary = Json::parse(text, is_shallow, false);
  if (summary.is_object())
    run.summary = std::move(summary);
  else
    run.missing.push_back("summary.json is damaged and was left out.");
}

/// A table and its text, both without what is damaged; "" where the table cannot be used.
std::optional<CsvTable> read_columns(RunRecord& run, const char* name, std::string& text,
                                     const std::string& absent) {
  SoundRows rows = sound_rows(text_of(run, name, absent));
  if (rows.cut)
    run.missing.push_back(
        fmt::format("The last line of {} is not complete and was left out.", name));
  if (rows.damaged > 0)
    run.missing.push_back(
        fmt::format("{}: {} damaged and left out, the first in line {}.", name,
                    rows.damaged == 1 ? "1 row is" : fmt::format("{} rows are", rows.damaged),
                    rows.first_damaged));
  if (rows.text.empty()) return {};
  CsvTable table(name, rows.text);
  if (table.columns()[0].name == names::time) {
    text = std::move(rows.text);
    return table;
  }
  run.missing.push_back(
      fmt::format("{} does not begin with the column \"time [s]\", it may be of another version: "
                  "it was left out.",
                  name));
  return {};
}

/// The sentences on tables: none at all, without rows, or without columns that are looked for.
void check_history(RunRecord& run) {
  if (!run.history) return;
  if (run.history->rows() == 0) run.missing.push_back("history.csv has no rows yet.");
  std::vector<std::string> expected = {names::step, names::time_step, names::courant,
                                       names::divergence, names::speed};
  if (run.definition && !run.definition->cloth.empty())
    expected.insert(expected.end(), {names::stress, names::membrane_stress, names::bending_stress});
  for (const std::string& name : expected)
    if (!run.history->find(name))
      run.missing.push_back(
          fmt::format("history.csv has no column \"{}\": it may be of another version.", name));
}

/// Where the names lead in a document; null where they lead nowhere.
const Json* find(const Json& document, const std::vector<std::string>& names) {
  const Json* at = &document;
  for (const std::string& name : names) {
    if (!at->is_object() || !at->contains(name)) return nullptr;
    at = &at->at(name);
  }
  return at;
}

}  // namespace

RunRecord read_run(const std::string& directory) {
  check_directory(directory);
  RunRecord run;
  run.directory = directory;
  run.name = last_part(directory);
  read_definition(run);
  read_summary(run);
  run.history = read_columns(run, "history.csv", run.history_text,
                             "There is no history.csv: there are no curves over time.");
  const bool cloth = run.definition && !run.definition->cloth.empty();
  run.tracks =
      read_columns(run, "tracks.csv", run.tracks_text,
                   cloth ? "There is no tracks.csv: the paths of the pieces are not known." : "");
  check_history(run);
  return run;
}

std::string outcome(const RunRecord& run) {
  const Json* text = find(run.summary, {names::run, names::outcome});
  return text && text->is_string() ? text->get<std::string>() : "unfinished";
}

std::optional<int> known_dimension(const RunRecord& run) {
  if (run.definition) return run.definition->dimension;
  const auto* energy = run.history ? run.history->find(names::kinetic_energy) : nullptr;
  if (!energy) return {};
  return energy->unit == joule.in(2) ? 2 : 3;
}

int dimension(const RunRecord& run) { return known_dimension(run).value_or(3); }

std::optional<double> summary_number(const RunRecord& run, const std::vector<std::string>& names) {
  const Json* found = find(run.summary, names);
  return found && found->is_number() ? std::optional(found->get<double>()) : std::nullopt;
}

std::vector<double> summary_numbers(const RunRecord& run, const std::vector<std::string>& names) {
  const Json* found = find(run.summary, names);
  std::vector<double> numbers;
  if (found && found->is_array())
    for (const Json& number : *found)
      if (number.is_number()) numbers.push_back(number.get<double>());
  return numbers;
}

}  // namespace washtub
