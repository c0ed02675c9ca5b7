#include "verify/figures.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "io/file.hpp"
#include "verify/judge.hpp"
#include "verify/series.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

/// Readable on white and on black, and told apart by those who do not see red and green.
constexpr const char* colours[] = {"#3b82d6", "#e07b1a", "#2a9d6f",
                                   "#c653a8", "#b59a1c", "#d1495b"};
constexpr std::size_t most_points = 1500;  ///< of a curve over time

struct Points {
  std::string label;
  bool over_time = false, given = false;
  std::vector<double> x, y;
};

const RunResult& run_of(const CaseRuns& c, const std::string& name) {
  return c.runs[c.expected.run_index(name)];
}

Points over_time(const CaseRuns& c, const Curve& curve) {
  Points points{curve.label, true, false, {}, {}};
  const RunResult& run = run_of(c, curve.run);
  if (!run.finished()) return points;
  const CsvTable history = read_table(run.directory + "/history.csv");
  Series column = series(history, curve.column, curve.window);
  if (!curve.minus.empty()) column = difference(column, series(history, curve.minus, curve.window));
  const std::size_t stride = 1 + column.values.size() / most_points;
  for (std::size_t i = 0; i < column.values.size(); i += stride) {
    points.x.push_back(column.times[i]);
    points.y.push_back(column.values[i] / curve.per);
  }
  return points;
}

Points over_runs(const CaseRuns& c, const Curve& curve) {
  Points points{curve.label, false, false, {}, {}};
  for (std::size_t i = 0; i < curve.runs.size(); ++i) {
    const RunResult& run = run_of(c, curve.runs[i]);
    if (!run.finished()) continue;
    points.x.push_back(curve.x[i]);
    points.y.push_back(measured_number(curve, run));
  }
  return points;
}

Points points_of(const CaseRuns& c, const Curve& curve) {
  if (!curve.run.empty()) return over_time(c, curve);
  if (!curve.runs.empty()) return over_runs(c, curve);
  return {curve.label, false, true, curve.x, curve.values};
}

/// A text between double quotes for gnuplot.
std::string gnuplot_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c == '\n' || c == '`' ? ' ' : c;
  }
  return result + '"';
}

void add_data(std::string& script, std::size_t number, const Points& points) {
  script += fmt::format("$c{} << END\n", number);
  for (std::size_t i = 0; i < points.x.size(); ++i)
    script += fmt::format("{:.8g} {:.8g}\n", points.x[i], points.y[i]);
  script += "END\n";
}

std::string plot_of(std::size_t number, const Points& points, std::size_t colour) {
  const char* style = points.over_time ? "lines"
                      : points.given   ? "linespoints dashtype 2 pointtype 6"
                                       : "linespoints pointtype 7";
  return fmt::format("$c{} using 1:2 with {} linewidth {} linecolor rgb \"{}\" title {} noenhanced",
                     number, style, points.given ? 1 : 2, colours[colour % std::size(colours)],
                     gnuplot_text(points.label));
}

/// A power of x below the first curve's last point, over the abscissae of all.
std::string slope_of(double power, const std::vector<Points>& curves) {
  double low = INFINITY, high = 0, least = INFINITY;
  for (const Points& c : curves)
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      low = std::min(low, c.x[i]);
      high = std::max(high, c.x[i]);
      least = std::min(least, c.y[i]);
    }
  return fmt::format(
      "[{:.6g}:{:.6g}] {:.6g}*(x/{:.6g})**{:.6g} with lines dashtype 3 linecolor rgb \"#888888\" "
      "title \"slope {:g}\"",
      low, high, 0.7 * least, low, power, power);
}

/// Unique on a page of several cases; gnuplot takes letters, digits and _.
std::string svg_name(const std::string& text) {
  std::string name = text;
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
  return name;
}

std::string head(const std::string& case_name, const Figure& figure) {
  std::string script = fmt::format(
      "set terminal svg size 760,420 dynamic name \"{}\" font \"sans-serif,13\"\n"
      "set grid linecolor rgb \"#999999\"\nset key outside right top\n"
      "set xlabel {} noenhanced\nset ylabel {} noenhanced\n",
      svg_name(case_name + '_' + figure.name), gnuplot_text(figure.x_label),
      gnuplot_text(figure.y_label));
  if (figure.kind == FigureKind::convergence) script += "set logscale xy\nset format y \"%.0e\"\n";
  return script;
}

/// SVG for a page: without header; black becomes the colour of the text around it.
std::string for_page(std::string svg) {
  const auto start = svg.find("<svg");
  if (start == std::string::npos) return "";
  svg.erase(0, start);
  const std::pair<const char*, const char*> changes[] = {
      {" color=\"black\"", ""},
      {"fill=\"black\"", "fill=\"currentColor\""},
      {"stroke=\"black\"", "stroke=\"currentColor\""},
      {"stroke='black'", "stroke='currentColor'"}};
  for (const auto& [from, to] : changes) {
    const std::string word = from, other = to;
    for (auto at = svg.find(word); at != std::string::npos; at = svg.find(word, at + other.size()))
      svg.replace(at, word.size(), other);
  }
  return svg;
}

std::string read(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string last_line(const fs::path& path) {
  std::ifstream file(path);
  std::string last;
  for (std::string line; std::getline(file, line);)
    if (!line.empty()) last = line;
  return last;
}

std::string shell_text(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + '\'';
}

/// Hands the script to gnuplot on its standard input.
Drawn draw(const std::string& script, const fs::path& base) {
  const std::string file = base.string() + ".gnuplot", svg = base.string() + ".svg";
  replace_file(file, script);
  const std::string command = fmt::format("gnuplot < {} > {} 2> {}", shell_text(file),
                                          shell_text(svg), shell_text(svg + ".log"));
  const int status = std::system(command.c_str());
  const std::string complaint = last_line(svg + ".log");
  fs::remove(svg + ".log");
  const std::string text = for_page(read(svg));
  if (status == 0 && !text.empty()) {
    const auto end = text.find('>', text.find("<svg"));
    replace_file(svg, text.substr(0, end + 1) +
                          "<style>svg{color:#222}@media(prefers-color-scheme:dark)"
                          "{svg{color:#ddd}}</style>" +
                          text.substr(end + 1));
    return {text, ""};
  }
  fs::remove(svg);
  if (WIFEXITED(status) && WEXITSTATUS(status) == 127)
    return {"", "not drawn: gnuplot is not installed; its Debian package is gnuplot-nox"};
  return {"", "not drawn, gnuplot says: " + complaint};
}

}  // namespace

std::string figure_script(const CaseRuns& c, const Figure& figure) {
  std::vector<Points> curves;
  bool any = false;
  for (const Curve& curve : figure.curves) {
    Points points = points_of(c, curve);
    if (points.x.empty()) continue;
    if (figure.kind == FigureKind::convergence)
      for (double& y : points.y) y = std::abs(y);
    any = any || !points.given;
    curves.push_back(std::move(points));
  }
  if (!any) return "";
  std::string script = head(c.expected.name, figure);
  std::vector<std::string> plots;
  std::size_t colour = 0;  // given points have that of the curve before them
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (i > 0 && !curves[i].given) ++colour;
    add_data(script, i, curves[i]);
    plots.push_back(plot_of(i, curves[i], colour));
  }
  for (const double line : figure.lines)
    plots.push_back(
        fmt::format("{:.8g} with lines dashtype 2 linecolor rgb \"#888888\" notitle", line));
  for (const double power : figure.slopes) plots.push_back(slope_of(power, curves));
  script += "plot ";
  for (std::size_t i = 0; i < plots.size(); ++i) script += (i ? ", \\\n  " : "") + plots[i];
  return script + '\n';
}

std::vector<Drawn> draw_figures(const CaseRuns& c, const std::string& directory) {
  const fs::path folder = fs::path(directory) / c.expected.name;
  fs::create_directories(folder);
  std::vector<Drawn> result;
  for (const Figure& figure : c.expected.figures) {
    try {
      const std::string script = figure_script(c, figure);
      result.push_back(script.empty() ? Drawn{"", "not drawn: none of its runs is finished"}
                                      : draw(script, folder / figure.name));
    } catch (const InputError& error) {
      result.push_back({"", std::string("not drawn: ") + error.what()});
    }
  }
  return result;
}

}  // namespace washtub
