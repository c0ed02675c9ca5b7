#include "base/format.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "base/nearest.hpp"
#include "base/schema.hpp"

namespace washtub {
namespace {

std::string or_list(const std::vector<std::string>& names) {
  std::vector<std::string> texts;
  for (const auto& name : names) texts.push_back(quoted(name));
  return fmt::format("{}", fmt::join(texts, ", "));
}

void check_range(const Node& node, double value, const Range& range, const char* unit) {
  if (!range.contains(value)) throw error_at(node, "allowed: " + range.text(unit));
}

double read_quantity(const Node& node, const Measure& measure, const Range& range) {
  const auto* text = std::get_if<std::string>(&node.value);
  if (!text)
    throw error_at(node, fmt::format("expected {} with its unit such as \"{}\"", measure.name,
                                     measure.example));
  double value = 0;
  try {
    value = parse_quantity(*text, measure);
  } catch (const InputError& error) {
    throw error_at(node, error.what());
  }
  check_range(node, value, range, measure.unit);
  return value;
}

double read_number(const Node& node, const Range& range) {
  double value = std::nan("");
  if (const auto* real = std::get_if<double>(&node.value)) value = *real;
  if (const auto* whole = std::get_if<std::int64_t>(&node.value))
    value = static_cast<double>(*whole);
  if (!std::isfinite(value)) throw error_at(node, "expected a number without unit such as 0.5");
  check_range(node, value, range, "");
  if (std::abs(value) > largest_quantity)
    throw error_at(node, fmt::format("allowed: up to {:g} either way", largest_quantity));
  return value;
}

int read_integer(const Node& node, const Range& range) {
  const auto* whole = std::get_if<std::int64_t>(&node.value);
  if (!whole) throw error_at(node, "expected an integer such as 16");
  const Range representable =
      between(std::max(range.least, -2147483647.0), std::min(range.most, 2147483647.0));
  if (!representable.contains(static_cast<double>(*whole)))
    throw error_at(node, "allowed: " + (range.text().empty() ? representable : range).text());
  return static_cast<int>(*whole);
}

std::string quoted_quantity(double value, const Measure& measure) {
  return quoted(quantity_text(value, measure));
}

std::string entry_type(const Measure& measure) {
  return fmt::format("{} [{}]", measure.name, measure.unit);
}

}  // namespace

bool Range::contains(double value) const {
  return (least_excluded ? value > least : value >= least) && value <= most;
}

std::string Range::text(const char* unit) const {
  const std::string gap = *unit ? " " : "";
  const char* sign = least_excluded ? ">" : ">=";
  if (std::isinf(least) && std::isinf(most)) return "";
  if (std::isinf(most)) return fmt::format("{} {}{}{}", sign, least, gap, unit);
  if (std::isinf(least)) return fmt::format("<= {}{}{}", most, gap, unit);
  if (least_excluded) return fmt::format("> {} and <= {}{}{}", least, most, gap, unit);
  return fmt::format("{} to {}{}{}", least, most, gap, unit);
}

Range above(double least) { return {.least = least, .least_excluded = true}; }
Range at_least(double least) { return {.least = least}; }
Range between(double least, double most) { return {.least = least, .most = most}; }

Format<double> quantity(const Measure& measure, const Range& range) {
  return {[=](const Node& node, int) { return read_quantity(node, measure, range); },
          [=](double value, int) { return quoted_quantity(value, measure); }, entry_type(measure),
          range.text(measure.unit), json_schema::quantity(measure)};
}

Format<double> number(const Range& range) {
  return {[=](const Node& node, int) { return read_number(node, range); },
          [](double value, int) { return number_text(value); }, "number", range.text(),
          json_schema::number(range)};
}

Format<int> integer(const Range& range) {
  return {[=](const Node& node, int) { return read_integer(node, range); },
          [](int value, int) { return std::to_string(value); }, "integer", range.text(),
          json_schema::integer(range)};
}

Format<std::uint64_t> seed() {
  return {[](const Node& node, int) {
            const auto* whole = std::get_if<std::int64_t>(&node.value);
            if (!whole) throw error_at(node, "expected an integer such as 1");
            check_range(node, static_cast<double>(*whole), at_least(0), "");
            return static_cast<std::uint64_t>(*whole);
          },
          [](std::uint64_t value, int) { return std::to_string(value); }, "integer", ">= 0",
          json_schema::integer(at_least(0))};
}

Format<bool> boolean() {
  return {[](const Node& node, int) {
            const auto* flag = std::get_if<bool>(&node.value);
            if (!flag) throw error_at(node, "expected true or false");
            return *flag;
          },
          [](bool value, int) { return std::string(value ? "true" : "false"); }, "true or false",
          "", json_schema::boolean()};
}

Format<std::string> text() {
  return {[](const Node& node, int) {
            const auto* text = std::get_if<std::string>(&node.value);
            if (!text) throw error_at(node, "expected a text between quotes");
            return *text;
          },
          [](const std::string& value, int) { return quoted(value); }, "text", "",
          json_schema::text()};
}

Format<std::string> label() {
  Format<std::string> format = text();
  format.read = [](const Node& node, int dimension) {
    const std::string name = text().read(node, dimension);
    const auto wrong = [](char c) {
      return std::string_view(",[]\"\x7f").find(c) != std::string_view::npos ||
             static_cast<unsigned char>(c) < ' ';
    };
    if (name.empty() || std::any_of(name.begin(), name.end(), wrong))
      throw error_at(node,
                     "expected a name without comma, brackets, quotation marks, line breaks and "
                     "control characters");
    return name;
  };
  format.schema = json_schema::text("^[^,\\[\\]\"\\u0000-\\u001f\\u007f]+$");
  format.allowed = "no `,` `[` `]` `\"` nor control characters";
  return format;
}

Format<int> name_of(const std::vector<std::string>& names) {
  return {[=](const Node& node, int) {
            const auto* text = std::get_if<std::string>(&node.value);
            for (size_t i = 0; text && i < names.size(); ++i)
              if (*text == names[i]) return static_cast<int>(i);
            const std::string nearest = text ? nearest_name(*text, names) : "";
            const std::string hint = nearest.empty() ? "" : ", nearest: " + quoted(nearest);
            throw error_at(node, "expected one of " + or_list(names) + hint);
          },
          [=](int position, int) { return quoted(names[static_cast<size_t>(position)]); }, "choice",
          or_list(names), json_schema::names(names)};
}

Format<std::string> one_of(const std::vector<std::string>& names) {
  const Format<int> by_name = name_of(names);
  return {[=](const Node& node, int dimension) {
            return names[static_cast<size_t>(by_name.read(node, dimension))];
          },
          [](const std::string& name, int) { return quoted(name); }, by_name.type, by_name.allowed,
          by_name.schema};
}

}  // namespace washtub
