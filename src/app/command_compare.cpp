#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/commands.hpp"
#include "app/protect.hpp"
#include "app/size.hpp"
#include "app/text_table.hpp"
#include "ensemble/ensemble.hpp"
#include "report/comparison.hpp"
#include "report/page.hpp"

namespace washtub {

namespace {

/// "168000 +- 25000", the half width as far as it is known.
std::string value_text(const std::optional<RunQuantity>& value) {
  if (!value) return "-";
  const auto width = value->half_width();
  if (!width || *width == 0) return as_exact(value->mean, {});
  return fmt::format("{} +- {}", as_exact(value->mean, width), as_exact(*width, width));
}

/// "+12.0 % +- 7.1 % *", the star for what is significant; in the unit where the first value is 0.
std::string difference_text(const std::optional<AgainstFirst>& d, const CompareRow& row) {
  if (!d) return "-";
  if (d->difference == 0) return "the same";
  const double unit = d->relative ? 100 / std::abs(row.values[0]->mean) : 1;
  const std::string name = d->relative ? "%" : row.unit;
  if (!d->half_width) return fmt::format("{:+.3g} {}", d->difference * unit, name);
  const double width = *d->half_width * unit;
  const std::string value = as_exact(d->difference * unit, width);
  return fmt::format("{}{} {} +- {} {}{}", d->difference > 0 ? "+" : "", value, name,
                     as_exact(width, width), name,
                     std::string(*d->significant() ? " *" : "") + (d->paired ? " =" : ""));
}

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
      table.back().push_back(difference_text(row.against[run], row));
    }
  }
  return table;
}

std::vector<Compared> read_all(const std::vector<std::string>& directories) {
  std::vector<Compared> all;
  for (const std::string& directory : directories)
    all.push_back(is_ensemble(directory) ? compared(read_ensemble(directory))
                                         : Compared(read_run(directory)));
  prepare_comparison(all);
  return all;
}

}  // namespace

int command_compare(const CompareArguments& arguments) {
  const std::size_t limit = parse_size(arguments.size);
  std::vector<Compared> all = read_all(arguments.directories);
  protect_page(arguments.file);
  const RunComparison comparison = compare(all);
  PageContent content{program_name, {}, to_json(comparison), nullptr};
  for (Compared& one : all) content.runs.push_back(std::move(one.run));
  const PageSize size = write_page(arguments.file, content, limit);
  print(text_table(comparison));
  fmt::print("* significant at 95 %; = of runs that start alike\n\n{}\n",
             fmt::join(comparison.sentences, "\n"));
  fmt::print("\n{}: {:.1f} MB, {} frames\n", arguments.file, 1e-6 * static_cast<double>(size.bytes),
             size.frames);
  return 0;
}

}  // namespace washtub
