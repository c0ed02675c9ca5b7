#pragma once
#include <array>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "base/document.hpp"
#include "base/units.hpp"
#include "base/vec.hpp"

namespace washtub {

/// Allowed values of a number, in the unit of its key.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_excluded = false;

  bool contains(double value) const;
  std::string text(const char* unit = "") const;  ///< "> 0 Pa s"; "" where anything goes
};
inline Range any() { return {}; }
Range above(double least);
Range at_least(double least);
Range between(double least, double most);

/// How values of type V are written in a case file.
/// `read` throws an InputError that names place, key, what was expected; `write` gives TOML.
/// Lists have one entry per axis where V is a vector, so both need the case's dimension.
template <class V>
struct Format {
  std::function<V(const Node&, int dimension)> read;
  std::function<std::string(const V&, int dimension)> write;
  std::string type;           ///< for the input reference
  std::string allowed;        ///< for the input reference; "" where anything goes
  std::string schema = "{}";  ///< JSON schema of the value
};

Format<double> quantity(const Measure& measure, const Range& range = any());
Format<double> number(const Range& range = any());
Format<int> integer(const Range& range = any());
Format<std::uint64_t> seed();
Format<bool> boolean();
Format<std::string> text();
/// A name that can stand at the head of a column: not empty, and without `,` `[` `]` `"` and
/// control characters.
Format<std::string> label();

/// One quantity per axis.
Format<Vec<3>> vector(const Measure& measure, const Range& range = any());
/// One number per axis.
Format<Vec<3>> direction();
/// One count per axis; a single integer stands for all axes.
Format<std::array<int, 3>> counts(const Range& range);
/// One quantity per direction along a sheet of cloth: two in 3-D, one in 2-D.
Format<std::array<double, 2>> extents(const Measure& measure, const Range& range);
/// One count per direction along a sheet of cloth; a single integer stands for all directions.
Format<std::array<int, 2>> sheet_counts(const Range& range);
/// One true or false per direction along a sheet of cloth; a single one stands for all directions.
Format<std::array<bool, 2>> sheet_flags();
/// One formula per axis of the variables x, y (and z in 3-D), r = sqrt(x^2 + y^2) and, if asked
/// for, t: in SI units; or a quantity. Read as the texts of formulas.
Format<std::array<std::string, 3>> formulas(const Measure& measure, bool with_time);
/// The variables of such a formula, in the order x, y, z, r, t.
std::vector<std::string> formula_variables(int dimension, bool with_time);
/// A begin and an end.
Format<std::array<double, 2>> interval(const Measure& measure, const Range& range);
/// Any number of quantities.
Format<std::vector<double>> quantities(const Measure& measure, const Range& range = any());
/// Any number of pairs of quantities.
Format<std::vector<Vec<2>>> points(const Measure& measure);

/// One of several names, as it stands.
Format<std::string> one_of(const std::vector<std::string>& names);
/// One of several names: the position of the name.
Format<int> name_of(const std::vector<std::string>& names);
/// Any number of several names: their positions. A name alone counts as a list of one.
Format<std::vector<int>> names_of(const std::vector<std::string>& names);

template <class E>
Format<E> choice(const std::vector<std::pair<std::string, E>>& options) {
  std::vector<std::string> names;
  for (const auto& [name, value] : options) names.push_back(name);
  const Format<int> by_name = name_of(names);
  auto read = [=](const Node& node, int dimension) {
    return options[static_cast<size_t>(by_name.read(node, dimension))].second;
  };
  auto write = [=](const E& value, int dimension) {
    int position = 0;
    while (options[static_cast<size_t>(position)].second != value) ++position;
    return by_name.write(position, dimension);
  };
  return {read, write, by_name.type, by_name.allowed, by_name.schema};
}

/// Any number of several names.
template <class E>
Format<std::vector<E>> choices(const std::vector<std::pair<std::string, E>>& options) {
  std::vector<std::string> names;
  for (const auto& option : options) names.push_back(option.first);
  const Format<std::vector<int>> by_name = names_of(names);
  auto read = [=](const Node& node, int dimension) {
    std::vector<E> values;
    for (const int position : by_name.read(node, dimension))
      values.push_back(options[static_cast<size_t>(position)].second);
    return values;
  };
  auto write = [=](const std::vector<E>& values, int dimension) {
    std::vector<int> positions;
    for (const E& value : values)
      for (size_t i = 0; i < options.size(); ++i)
        if (options[i].second == value) positions.push_back(static_cast<int>(i));
    return by_name.write(positions, dimension);
  };
  return {read, write, by_name.type, by_name.allowed, by_name.schema};
}

}  // namespace washtub
