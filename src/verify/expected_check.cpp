#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "base/nearest.hpp"
#include "verify/expected.hpp"

namespace washtub {
namespace {

/// Names that become files.
void check_file_name(const Node& table, const std::string& name) {
  const bool good =
      !name.empty() && name[0] != '.' && std::all_of(name.begin(), name.end(), [](unsigned char c) {
        return std::isalnum(c) || c == '-' || c == '_' || c == '.';
      });
  if (!good)
    throw error_at(*table.find("name"), "allowed: letters, digits, - and _, as in \"sharp-128\"");
}

template <class T>
void check_unique(const std::vector<T>& entries, const Node::List& nodes) {
  for (std::size_t i = 0; i < entries.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (entries[i].name == entries[j].name)
        throw error_at(*nodes[i].find("name"), "the name is taken, see " + nodes[j].where);
}

void check_runs(const Expected& expected, const Node::List& nodes) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const RunSpec& run = expected.runs[i];
    check_file_name(nodes[i], run.name);
    const auto file = std::filesystem::path(expected.directory) / run.file;
    if (!std::filesystem::is_regular_file(file))
      throw error_at(nodes[i], fmt::format("{}: no such case file", file.string()));
    if (!run.seeds.empty() && run.command != "run")
      throw error_at(*nodes[i].find("seeds"), "only runs can be of several seeds");
  }
}

/// The run that an entry names, or one of those it lists.
void check_run(const Expected& expected, const Node& entry, const std::string& key,
               const std::string& name, const std::string& command) {
  std::vector<std::string> names;
  for (const RunSpec& run : expected.runs) names.push_back(run.name);
  const std::size_t index = expected.run_index(name);
  const Node& node = *entry.find(key);
  if (index == names.size()) {
    const std::string nearest = nearest_name(name, names);
    throw error_at(node,
                   fmt::format("no run {}, {}", quoted(name),
                               nearest.empty() ? fmt::format("there are {}", fmt::join(names, ", "))
                                               : "nearest: " + quoted(nearest)));
  }
  if (expected.runs[index].command != command)
    throw error_at(node, fmt::format("is no `{}` run", command));
  if (!expected.runs[index].seeds.empty() && !entry.find("summary"))
    throw error_at(node, "is an ensemble, of which only `summary` can be asked");
}

/// Exactly one of several keys must be there.
void check_one_of(const Node& entry, const std::vector<std::string>& keys) {
  const auto given = std::count_if(keys.begin(), keys.end(),
                                   [&](const std::string& key) { return entry.find(key); });
  if (given != 1)
    throw error_at(entry, fmt::format("expected one of the keys {}, found {}",
                                      fmt::join(keys, ", "), given == 0 ? "none" : "several"));
}

void check_quantity(const Expected& expected, const Quantity& quantity, const Node& node) {
  check_one_of(node, {"run", "runs"});
  check_one_of(node, {"column", "summary", "mode"});
  check_one_of(node, {"value", "at_least", "at_most"});
  if (node.find("value") && quantity.decides)
    check_one_of(node, {"tolerance", "tolerance_percent"});
  if (quantity.source.empty()) throw error_at(*node.find("source"), "says nothing");
  if (node.find("column") && !node.find("take"))
    throw error_at(*node.find("column"), "missing key take: what is taken of the column");
  if (quantity.per == 0) throw error_at(*node.find("per"), "allowed: other than 0");
  if (quantity.is_order() && (quantity.runs.size() < 2 || quantity.runs.size() > 3))
    throw error_at(*node.find("runs"), "an order needs two or three runs");
  for (const std::string& run : quantity.used_runs())
    check_run(expected, node, quantity.is_order() ? "runs" : "run", run,
              quantity.mode > 0 ? "modes" : "run");
}

void check_curve(const Expected& expected, const Curve& curve, const Node& node) {
  check_one_of(node, {"run", "runs", "values"});
  if (curve.per == 0) throw error_at(*node.find("per"), "allowed: other than 0");
  if (node.find("values") || node.find("runs")) {
    const std::size_t count = node.find("values") ? curve.values.size() : curve.runs.size();
    if (curve.x.size() != count)
      throw error_at(node, fmt::format("{} entries of x for {} points", curve.x.size(), count));
  }
  if (node.find("values")) return;
  if (node.find("run")) {
    check_one_of(node, {"column"});
    return check_run(expected, node, "run", curve.run, "run");
  }
  check_one_of(node, {"column", "summary", "mode"});
  for (const std::string& run : curve.runs)
    check_run(expected, node, "runs", run, curve.mode > 0 ? "modes" : "run");
}

}  // namespace

void check_expected(const Expected& expected, const Node& root) {
  const auto runs = tables_in(root, "run");
  if (runs.empty()) throw InputError(root.where + ": missing table [[run]]");
  check_unique(expected.runs, runs);
  check_runs(expected, runs);
  const auto quantities = tables_in(root, "quantity");
  if (quantities.empty()) throw InputError(root.where + ": missing table [[quantity]]");
  check_unique(expected.quantities, quantities);
  for (std::size_t i = 0; i < quantities.size(); ++i)
    check_quantity(expected, expected.quantities[i], quantities[i]);
  const auto figures = tables_in(root, "figure");
  check_unique(expected.figures, figures);
  for (std::size_t i = 0; i < figures.size(); ++i) {
    check_file_name(figures[i], expected.figures[i].name);
    const auto curves = tables_in(figures[i], "curve");
    if (curves.empty()) throw error_at(figures[i], "missing table [[figure.curve]]");
    for (std::size_t j = 0; j < curves.size(); ++j)
      check_curve(expected, expected.figures[i].curves[j], curves[j]);
  }
}

}  // namespace washtub
