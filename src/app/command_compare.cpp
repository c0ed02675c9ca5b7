#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands.hpp"
#include "app/size.hpp"
#include "base/error.hpp"
#include "io/file.hpp"
#include "report/comparison.hpp"
#include "report/page.hpp"

namespace washtub {

namespace fs = std::filesystem;

namespace {

/// "1.677e+05 +- 2.5e+04", the half width as far as it is known.
std::string value_text(const std::optional<RunQuantity>& value) {
  if (!value) return "-";
  const auto width = value->half_width();
  return width ? fmt::format("{:.4g} +- {:.2g}", value->mean, *width)
               : fmt::format("{:.4g}", value->mean);
}

/// "+12 % +- 7.1 % *", the star for what is significant.
std::string difference_text(const std::optional<AgainstFirst>& d) {
  if (!d) return "-";
  std::string text = fmt::format("{:+.3g} %", d->percent);
  if (!d->half_width || d->difference == 0) return text;
  const double width = *d->half_width * std::abs(d->percent / d->difference);
  text += width < 9.95 ? fmt::format(" +- {:.2g} %", width) : fmt::format(" +- {:.0f} %", width);
  return *d->significant() ? text + " *" : text;
}

using TextRow = std::vector<std::string>;

std::vector<TextRow> text_table(const RunComparison& comparison) {
  std::vector<TextRow> table(1, TextRow{"quantity", comparison.names[0]});
  for (std::size_t run = 1; run < comparison.names.size(); ++run) {
    table[0].push_back(comparison.names[run]);
    table[0].push_back("against " + comparison.names[0]);
  }
  for (const CompareRow& row : comparison.rows) {
    table.push_back({fmt::format("{} [{}]", row.name, row.unit), value_text(row.values[0])});
    for (std::size_t run = 1; run < row.values.size(); ++run) {
      table.back().push_back(value_text(row.values[run]));
      table.back().push_back(difference_text(row.against[run]));
    }
  }
  return table;
}

void print(const std::vector<TextRow>& table) {
  std::vector<std::size_t> widths(table[0].size());
  for (const TextRow& row : table)
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  for (const TextRow& row : table) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i)
      line += fmt::format("{:<{}}", row[i], i + 1 < row.size() ? widths[i] + 2 : 0);
    fmt::print("{}\n", line);
  }
}

/// @throws InputError where something stands there that is no page of this program
void protect_file(const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return;
  if (fs::is_directory(path, error))
    throw InputError(fmt::format("{}: is a directory; name a file with -o", path));
  if (read_file(path).find("id=\"washtub-data\"") == std::string::npos)
    throw InputError(
        fmt::format("{}: exists and is no page of washtub; name another file with -o", path));
}

std::vector<RunRecord> read_runs(const std::vector<std::string>& directories) {
  std::vector<RunRecord> runs;
  for (const std::string& directory : directories) runs.push_back(read_run(directory));
  prepare_comparison(runs);
  return runs;
}

}  // namespace

int command_compare(const CompareArguments& arguments) {
  const std::size_t limit = parse_size(arguments.size);
  PageContent content{"washtub " WASHTUB_VERSION, read_runs(arguments.directories), nullptr};
  protect_file(arguments.file);
  const RunComparison comparison = compare(content.runs);
  print(text_table(comparison));
  fmt::print("* significant at 95 %\n\n{}\n", fmt::join(comparison.sentences, "\n"));
  content.comparison = to_json(comparison);
  const PageSize size = write_page(arguments.file, content, limit);
  fmt::print("\n{}: {:.1f} MB, {} frames\n", arguments.file, 1e-6 * static_cast<double>(size.bytes),
             size.frames);
  return 0;
}

}  // namespace washtub
