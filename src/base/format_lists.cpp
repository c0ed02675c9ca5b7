#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/expression.hpp"
#include "base/format.hpp"
#include "base/schema.hpp"

namespace washtub {
namespace {

/// The entries of a list of a required length, or of any length where `count` is 0.
const Node::List& read_list(const Node& node, size_t count, const std::string& what) {
  if (node.is_list() && (count == 0 || node.list().size() == count)) return node.list();
  throw error_at(node, count == 0 ? fmt::format("expected a list of {}", what)
                                  : fmt::format("expected a list of {} {}", count, what));
}

std::string list_text(const std::vector<std::string>& entries) {
  return fmt::format("[{}]", fmt::join(entries, ", "));
}

std::string entries_of(const Measure& measure) {
  return fmt::format("quantities such as \"{}\"", measure.example);
}

/// A list with one entry per axis (`drop` 0) or per direction along a sheet (`drop` 1); what has
/// no entry is taken from `rest`.
template <class V, class Entry>
Format<V> per_axis(const Format<Entry>& entry, int drop, const std::string& what, V rest) {
  auto read = [=](const Node& node, int dimension) {
    V values = rest;
    const auto count = static_cast<size_t>(dimension - drop);
    const Node::List& list = read_list(node, count, what);
    for (size_t i = 0; i < count; ++i) values[i] = entry.read(list[i], dimension);
    return values;
  };
  auto write = [=](const V& values, int dimension) {
    std::vector<std::string> texts;
    for (size_t i = 0; i < static_cast<size_t>(dimension - drop); ++i)
      texts.push_back(entry.write(values[i], dimension));
    return list_text(texts);
  };
  const char* per = drop == 0 ? "one per axis" : "one per direction of the sheet";
  const auto most = static_cast<size_t>(3 - drop);
  return {read, write, fmt::format("{}, {}", entry.type, per), entry.allowed,
          json_schema::list(entry.schema, most - 1, most)};
}

/// One entry per direction along a sheet; a single one stands for all of them.
template <class V, class Entry>
Format<V> alone_for_all(const Format<Entry>& one, const std::string& what, V rest) {
  auto format = per_axis<V>(one, 1, what, rest);
  format.read = [=, list = format.read](const Node& node, int dimension) {
    if (node.is_list()) return list(node, dimension);
    V all = rest;
    for (size_t i = 0; i + 1 < static_cast<size_t>(dimension); ++i)
      all[i] = one.read(node, dimension);
    return all;
  };
  format.type = one.type + ", or one per direction of the sheet";
  format.schema = json_schema::either(one.schema, format.schema);
  return format;
}

template <class Entry>
Format<std::vector<Entry>> list_of(const Format<Entry>& entry, const std::string& what) {
  auto read = [=](const Node& node, int dimension) {
    std::vector<Entry> values;
    for (const Node& item : read_list(node, 0, what)) values.push_back(entry.read(item, dimension));
    return values;
  };
  auto write = [=](const std::vector<Entry>& values, int dimension) {
    std::vector<std::string> texts;
    for (const Entry& value : values) texts.push_back(entry.write(value, dimension));
    return list_text(texts);
  };
  return {read, write, "list of " + entry.type, entry.allowed, json_schema::list(entry.schema)};
}

/// The text of a formula; a quantity becomes its SI value.
std::string read_formula(const Node& node, const Measure& measure,
                         const std::vector<std::string>& variables) {
  const auto* text = std::get_if<std::string>(&node.value);
  if (!text)
    throw error_at(node, fmt::format("expected a formula in {} between quotes such as \"2 * x\", "
                                     "or \"{}\"",
                                     measure.unit, measure.example));
  try {
    return number_text(parse_quantity(*text, measure));
  } catch (const InputError&) {  // then it is a formula
  }
  try {
    const Expression formula(*text, variables);
  } catch (const InputError& error) {
    throw error_at(node, error.what());
  }
  return *text;
}

Format<std::string> formula(const Measure& measure, bool with_time) {
  return {[=](const Node& node, int dimension) {
            return read_formula(node, measure, formula_variables(dimension, with_time));
          },
          [](const std::string& text, int) { return quoted(text); },
          fmt::format("formula [{}]", measure.unit), "", json_schema::text()};
}

}  // namespace

std::vector<std::string> formula_variables(int dimension, bool with_time) {
  std::vector<std::string> variables = {"x", "y"};
  if (dimension == 3) variables.push_back("z");
  variables.push_back("r");
  if (with_time) variables.push_back("t");
  return variables;
}

Format<std::array<std::string, 3>> formulas(const Measure& measure, bool with_time) {
  auto format = per_axis<std::array<std::string, 3>>(formula(measure, with_time), 0,
                                                     "formulas such as \"2 * x\"", {"0", "0", "0"});
  format.allowed = fmt::format("of x, y, z, r = sqrt(x^2 + y^2){}", with_time ? ", t" : "");
  return format;
}

Format<std::vector<int>> names_of(const std::vector<std::string>& names) {
  auto format = list_of(name_of(names), "names such as " + quoted(names.front()));
  format.read = [one = name_of(names), list = format.read](const Node& node, int dimension) {
    if (node.is_list()) return list(node, dimension);
    return std::vector<int>{one.read(node, dimension)};
  };
  format.schema = json_schema::either(name_of(names).schema, format.schema);
  return format;
}

Format<Vec<3>> vector(const Measure& measure, const Range& range) {
  return per_axis<Vec<3>>(quantity(measure, range), 0, entries_of(measure), Vec<3>::Zero());
}

Format<Vec<3>> direction() {
  return per_axis<Vec<3>>(number(), 0, "numbers such as 0.5", Vec<3>::Zero());
}

Format<std::array<int, 3>> counts(const Range& range) {
  const auto one = integer(range);
  auto format = per_axis<std::array<int, 3>>(one, 0, "integers such as 64", {1, 1, 1});
  format.read = [list = format.read, one](const Node& node, int dimension) {
    if (node.is_list()) return list(node, dimension);
    const int all = one.read(node, dimension);
    return std::array<int, 3>{all, all, dimension == 3 ? all : 1};
  };
  format.type = "integer, or one per axis";
  format.schema = json_schema::either(one.schema, format.schema);
  return format;
}

Format<std::array<double, 2>> extents(const Measure& measure, const Range& range) {
  return per_axis<std::array<double, 2>>(quantity(measure, range), 1, entries_of(measure), {0, 0});
}

Format<std::array<int, 2>> sheet_counts(const Range& range) {
  return alone_for_all<std::array<int, 2>>(integer(range), "integers such as 7", {1, 1});
}

Format<std::array<bool, 2>> sheet_flags() {
  return alone_for_all<std::array<bool, 2>>(boolean(), "values true or false", {false, false});
}

Format<std::array<double, 2>> interval(const Measure& measure, const Range& range) {
  const auto entry = quantity(measure, range);
  auto read = [=](const Node& node, int dimension) {
    const Node::List& list = read_list(node, 2, entries_of(measure));
    return std::array<double, 2>{entry.read(list[0], dimension), entry.read(list[1], dimension)};
  };
  auto write = [=](const std::array<double, 2>& value, int dimension) {
    return list_text({entry.write(value[0], dimension), entry.write(value[1], dimension)});
  };
  return {read, write, "pair of " + entry.type, entry.allowed,
          json_schema::list(entry.schema, 2, 2)};
}

Format<std::vector<double>> quantities(const Measure& measure, const Range& range) {
  return list_of(quantity(measure, range), entries_of(measure));
}

Format<std::vector<Vec<2>>> points(const Measure& measure) {
  const auto pair = interval(measure, any());
  Format<Vec<2>> point;
  point.read = [=](const Node& node, int dimension) {
    const auto value = pair.read(node, dimension);
    return Vec<2>(value[0], value[1]);
  };
  point.write = [=](const Vec<2>& value, int dimension) {
    return pair.write({value.x(), value.y()}, dimension);
  };
  point.type = pair.type;
  point.schema = pair.schema;
  return list_of(point, "pairs of " + entries_of(measure));
}

}  // namespace washtub
