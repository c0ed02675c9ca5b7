#include "io/table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include "base/document.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"
#include "io/file.hpp"

namespace washtub {
namespace {

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields(1);
  for (const char c : line) {
    if (c == ',') fields.emplace_back();
    if (c != ',' && c != '\r') fields.back() += c;
  }
  return fields;
}

/// NaN for an empty field; nothing where it is no number.
std::optional<double> parse_number(const std::string& field) {
  if (field.empty()) return std::nan("");
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  return end == field.c_str() + field.size() ? std::optional(value) : std::nullopt;
}

double number_of(const std::string& field, const std::string& path, std::size_t line) {
  if (const auto value = parse_number(field)) return *value;
  throw InputError(fmt::format("{}:{}: \"{}\" is no number", path, line, field));
}

bool is_sound(const std::string& line, std::size_t columns) {
  const auto fields = fields_of(line);
  const auto is_number = [](const std::string& field) { return parse_number(field).has_value(); };
  return fields.size() == columns && std::all_of(fields.begin(), fields.end(), is_number) &&
         std::isfinite(*parse_number(fields[0]));
}

CsvTable::Column empty_column(const std::string& header) {
  const auto gap = header.rfind(" [");
  if (gap == std::string::npos || !header.ends_with(']')) return {header, "", {}};
  return {header.substr(0, gap), header.substr(gap + 2, header.size() - gap - 3), {}};
}

std::string header_of(const CsvTable::Column& column) {
  return column.unit.empty() ? column.name : fmt::format("{} [{}]", column.name, column.unit);
}

}  // namespace

CsvTable::CsvTable(std::string path, const std::string& text) : path_(std::move(path)) {
  std::size_t line = 1;
  std::size_t begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1)
    add(text.substr(begin, end - begin), line++);
  cut_ = begin < text.size();
  if (line == 1) throw InputError(fmt::format("{}: has no header line", path_));
}

void CsvTable::add(const std::string& line, std::size_t number) {
  const auto fields = fields_of(line);
  if (number == 1) {
    for (const auto& header : fields) columns_.push_back(empty_column(header));
    return;
  }
  if (fields.size() != columns_.size())
    throw InputError(fmt::format("{}:{}: {} fields, expected {}", path_, number, fields.size(),
                                 columns_.size()));
  for (std::size_t i = 0; i < fields.size(); ++i)
    columns_[i].values.push_back(number_of(fields[i], path_, number));
}

const CsvTable::Column* CsvTable::find(const std::string& name) const {
  for (const Column& column : columns_)
    if (name == column.name || name == header_of(column)) return &column;
  return nullptr;
}

const CsvTable::Column& CsvTable::column(const std::string& name) const {
  if (const Column* found = find(name)) return *found;
  std::vector<std::string> names;
  for (const Column& column : columns_) names.push_back(column.name);
  const std::string nearest = nearest_name(name, names);
  throw InputError(fmt::format("{}: no column {}, {}", path_, quoted(name),
                               nearest.empty() ? fmt::format("there are {}", fmt::join(names, ", "))
                                               : "nearest: " + quoted(nearest)));
}

SoundRows sound_rows(const std::string& text) {
  SoundRows sound;
  std::size_t columns = 0, number = 1, begin = 0;
  for (std::size_t end; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string line = text.substr(begin, end - begin);
    if (number == 1) columns = fields_of(line).size();
    if (number == 1 || is_sound(line, columns))
      sound.text += line + '\n';
    else if (sound.damaged++ == 0)
      sound.first_damaged = number;
    ++number;
  }
  sound.cut = begin < text.size();
  return sound;
}

CsvTable read_table(const std::string& path) { return {path, read_file(path)}; }

}  // namespace washtub
