#include "verify/expected.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace washtub {

namespace fs = std::filesystem;

namespace {

/// A list of any length, each entry in the format given.
template <class V>
Format<std::vector<V>> list_of(const Format<V>& entry) {
  auto read = [=](const Node& node, int dimension) {
    if (!node.is_list()) throw error_at(node, fmt::format("expected a list of {}", entry.type));
    std::vector<V> values;
    for (const Node& member : node.list()) values.push_back(entry.read(member, dimension));
    return values;
  };
  auto write = [=](const std::vector<V>& values, int dimension) {
    std::string text;
    for (const V& value : values)
      text += (text.empty() ? "" : ", ") + entry.write(value, dimension);
    return "[" + text + "]";
  };
  return {read, write, "list of " + entry.type, entry.allowed};
}

Format<std::string> command() {
  const auto names = name_of({"run", "modes"});
  return {[=](const Node& node, int d) { return names.read(node, d) == 0 ? "run" : "modes"; },
          [](const std::string& value, int) { return quoted(value); }, names.type, names.allowed};
}

Format<VerifyLevel> level() {
  return choice<VerifyLevel>({{"quick", VerifyLevel::quick}, {"full", VerifyLevel::full}});
}

Table<RunSpec> run_table() {
  const auto empty = [](const RunSpec& r, int) { return r.settings.empty(); };
  const auto unknown = [](const RunSpec& r, int) { return r.cost == 0; };
  Table<RunSpec> table("A run. Repeat `[[run]]` for several.");
  table.key("name", &RunSpec::name, text(), "name in this file, and of its folder in the results")
      .required()
      .key("level", &RunSpec::level, level(), "`full` takes in the quick ones")
      .key("case", &RunSpec::file, text(), "case file beside this one")
      .key("command", &RunSpec::command, command(), "command of washtub that makes it")
      .key("seeds", &RunSpec::seeds, text(), "makes it an ensemble, as `5` or `6-10`")
      .omitted([](const RunSpec& r, int) { return r.seeds.empty(); })
      .key("set", &RunSpec::settings, list_of(text()), "what `--set` changes of the case")
      .omitted(empty)
      .key("cost", &RunSpec::cost, quantity(measure::time, above(0)),
           "about how long it takes; the longest start first")
      .omitted(unknown);
  return table;
}

/// The keys that say which number of a run is meant.
template <class T>
void add_measured(Table<T>& table) {
  const auto with_column = [](const T& q, int) { return !q.column.empty(); };
  table.key("column", &T::column, text(), "column of history.csv, its unit may be left out")
      .omitted([](const T& q, int) { return q.column.empty(); })
      .key("minus", &T::minus, text(), "a column to take off it")
      .only("with `column`", with_column)
      .omitted([](const T& q, int) { return q.minus.empty(); })
      .key("take", &T::take, choice<Take>(take_names()), "what is taken of the column")
      .fallback("must be given in a quantity")
      .only("with `column`", with_column)
      .key("window", &T::window, interval(measure::time, at_least(0)), "between these times")
      .only("with `column`", with_column)
      .fallback("the whole run")
      .key("per", &T::per, number(), "divides it")
      .key("summary", &T::summary, text(),
           "JSON pointer into summary.json, such as `/run/steps`, of an ensemble into pooled.json")
      .omitted([](const T& q, int) { return q.summary.empty(); })
      .key("mode", &T::mode, integer(at_least(1)), "natural frequency of a `modes` run, from 1")
      .omitted([](const T& q, int) { return q.mode == 0; });
}

/// A key that is a number or not given.
template <class T, class Access>
void add_number(Table<T>& table, const std::string& name, Access access, const Range& range,
                const std::string& meaning) {
  table.key(name, access, number(range), meaning).omitted([=](const T& q, int) {
    return std::isnan(q.*access);
  });
}

Table<Quantity> quantity_table() {
  const auto order = [](const Quantity& q, int) { return q.is_order(); };
  const auto valued = [](const Quantity& q, int) { return !std::isnan(q.value); };
  Table<Quantity> table("A number that a run computes and what it should be.");
  table.key("name", &Quantity::name, text(), "name in the reports")
      .required()
      .key("unit", &Quantity::unit, text(), "unit in the reports")
      .key("run", &Quantity::run, text(), "name of the run")
      .omitted([](const Quantity& q, int) { return q.run.empty(); });
  table
      .key("runs", &Quantity::runs, list_of(text()),
           "in place of `run`, from coarse to fine, for the observed order of convergence: of two "
           "runs log(e1/e2) / log(refinement), e their distance from `exact`; of three the same "
           "with the differences of neighbours as e")
      .omitted([](const Quantity& q, int) { return q.runs.empty(); })
      .key("refinement", &Quantity::refinement, number(above(1)), "ratio of neighbouring steps")
      .only("with `runs`", order)
      .key("exact", &Quantity::exact, number(), "what the runs tend to")
      .only("with two `runs`", [](const Quantity& q, int) { return q.runs.size() == 2; });
  add_measured(table);
  add_number(table, "value", &Quantity::value, any(), "what it should be");
  add_number(table, "tolerance", &Quantity::tolerance, at_least(0), "allowed distance from it");
  table.only("with `value`", valued);
  add_number(table, "tolerance_percent", &Quantity::tolerance_percent, at_least(0),
             "the same in percent of the value");
  table.only("with `value`", valued);
  add_number(table, "at_least", &Quantity::at_least, any(), "bound, in place of `value`");
  add_number(table, "at_most", &Quantity::at_most, any(), "bound, in place of `value`");
  add_number(table, "known_miss", &Quantity::known_miss, any(),
             "what is measured where it is known to miss and the README says why");
  table.key("decides", &Quantity::decides, boolean(), "false: shown, but never a miss")
      .key("source", &Quantity::source, text(), "where value and tolerance come from")
      .required();
  return table;
}

Table<Curve> curve_table() {
  Table<Curve> table("A curve of the figure.");
  table.key("label", &Curve::label, text(), "name in the key")
      .required()
      .key("run", &Curve::run, text(), "name of the run whose column is drawn over time")
      .omitted([](const Curve& c, int) { return c.run.empty(); })
      .key("runs", &Curve::runs, list_of(text()), "runs that give one point each")
      .omitted([](const Curve& c, int) { return c.runs.empty(); })
      .key("x", &Curve::x, list_of(number()), "where their points, or `values`, are")
      .omitted([](const Curve& c, int) { return c.x.empty(); })
      .key("values", &Curve::values, list_of(number()), "points of a reference, in place of runs")
      .omitted([](const Curve& c, int) { return c.values.empty(); });
  add_measured(table);
  return table;
}

Table<Figure> figure_table() {
  const auto none = [](const std::vector<double> Figure::*member) {
    return [=](const Figure& f, int) { return (f.*member).empty(); };
  };
  Table<Figure> table("A figure made of the runs.");
  table.key("name", &Figure::name, text(), "name of its file").required();
  table
      .key("kind", &Figure::kind,
           choice<FigureKind>(
               {{"history", FigureKind::history}, {"convergence", FigureKind::convergence}}),
           "over time, or both axes logarithmic")
      .key("caption", &Figure::caption, text(), "what it shows")
      .key("x_label", &Figure::x_label, text(), "name and unit of the abscissa")
      .key("y_label", &Figure::y_label, text(), "name and unit of the ordinate")
      .key("lines", &Figure::lines, list_of(number()), "horizontal lines of reference")
      .omitted(none(&Figure::lines))
      .key("slopes", &Figure::slopes, list_of(number()), "powers of x drawn as a guide")
      .omitted(none(&Figure::slopes))
      .only("in a convergence",
            [](const Figure& f, int) { return f.kind == FigureKind::convergence; })
      .list("curve", &Figure::curves, curve_table(), [](const Figure&) { return Curve(); });
  return table;
}

Table<Expected> declare() {
  Table<Expected> table("Keys of expected.toml.");
  table.key("title", &Expected::title, text(), "title of the case")
      .required()
      .key("about", &Expected::about, text(), "what it shows, in a sentence")
      .list("run", &Expected::runs, run_table(), [](const Expected&) { return RunSpec(); })
      .list("quantity", &Expected::quantities, quantity_table(),
            [](const Expected&) { return Quantity(); })
      .list("figure", &Expected::figures, figure_table(), [](const Expected&) { return Figure(); });
  return table;
}

}  // namespace

std::size_t Expected::run_index(const std::string& run) const {
  const auto hit =
      std::find_if(runs.begin(), runs.end(), [&](const RunSpec& spec) { return spec.name == run; });
  return static_cast<std::size_t>(hit - runs.begin());
}

VerifyLevel Expected::level_of(const Quantity& quantity) const {
  VerifyLevel level = VerifyLevel::quick;
  for (const std::string& run : quantity.used_runs())
    level = std::max(level, runs[run_index(run)].level);
  return level;
}

const Table<Expected>& expected_table() {
  static const Table<Expected> table = declare();
  return table;
}

Expected read_expected(const std::string& directory) {
  const fs::path folder = fs::path(directory).lexically_normal();
  const Node root = parse_file((folder / "expected.toml").string());
  check_known(root, expected_table().names());
  Expected expected;
  expected.directory = folder.string();
  expected.name = (folder / "").parent_path().filename().string();
  expected_table().read(expected, root, 2);
  check_expected(expected, root);
  return expected;
}

std::vector<std::string> case_names(const std::string& directory) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (fs::exists(entry.path() / "expected.toml"))
      names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  if (names.empty())
    throw InputError(fmt::format(
        "{}: no verification cases, that is folders with an expected.toml; name their folder with "
        "--cases",
        directory));
  return names;
}

}  // namespace washtub
