#include "verify/series.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/document.hpp"
#include "base/error.hpp"
#include "base/nearest.hpp"

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

/// NaN for an empty field.
double number_of(const std::string& field, const std::string& path, std::size_t row) {
  if (field.empty()) return std::nan("");
  char* end = nullptr;
  const double value = std::strtod(field.c_str(), &end);
  if (*end != '\0') throw InputError(fmt::format("{}:{}: \"{}\" is no number", path, row, field));
  return value;
}

}  // namespace

HistoryFile::HistoryFile(const std::string& path) : path_(path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw InputError(fmt::format("{}: cannot be read", path));
  headers_ = fields_of(line);
  for (const auto& header : headers_) names_.push_back(header.substr(0, header.find(" [")));
  columns_.resize(headers_.size());
  for (std::size_t row = 2; std::getline(file, line); ++row) {
    const auto fields = fields_of(line);
    if (fields.size() != headers_.size())
      throw InputError(
          fmt::format("{}:{}: {} fields, expected {}", path, row, fields.size(), headers_.size()));
    for (std::size_t i = 0; i < fields.size(); ++i)
      columns_[i].push_back(number_of(fields[i], path, row));
  }
}

std::size_t HistoryFile::find(const std::string& name) const {
  for (std::size_t i = 0; i < names_.size(); ++i)
    if (name == names_[i] || name == headers_[i]) return i;
  const std::string nearest = nearest_name(name, names_);
  throw InputError(fmt::format("{}: no column {}, {}", path_, quoted(name),
                               nearest.empty()
                                   ? fmt::format("there are {}", fmt::join(names_, ", "))
                                   : "nearest: " + quoted(nearest)));
}

Series HistoryFile::series(const std::string& name, const std::array<double, 2>& window) const {
  const auto& values = columns_[find(name)];
  const auto& times = columns_[0];
  const double slack = times.empty() ? 0 : 1e-9 * std::abs(times.back());
  Series result;
  bool ends_empty = false;
  for (std::size_t i = 0; i < times.size(); ++i) {
    if (times[i] < window[0] - slack || times[i] > window[1] + slack) continue;
    ends_empty = std::isnan(values[i]);
    if (ends_empty) continue;
    result.times.push_back(times[i]);
    result.values.push_back(values[i]);
  }
  if (ends_empty)
    throw InputError(
        fmt::format("{}: column {} has no value at the end of the window", path_, quoted(name)));
  return result;
}

Series difference(const Series& a, const Series& b) {
  if (a.times != b.times) throw InputError("the two columns have no values at the same times");
  Series result = a;
  for (std::size_t i = 0; i < a.values.size(); ++i) result.values[i] -= b.values[i];
  return result;
}

}  // namespace washtub
