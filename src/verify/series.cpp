#include "verify/series.hpp"

#include <fmt/format.h>

#include <cmath>

#include "base/document.hpp"
#include "base/error.hpp"

namespace washtub {

Series series(const CsvTable& table, const std::string& name, const std::array<double, 2>& window) {
  const auto& values = table.column(name).values;
  const auto& times = table.columns()[0].values;
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
    throw InputError(fmt::format("{}: column {} has no value at the end of the window",
                                 table.path(), quoted(name)));
  return result;
}

Series difference(const Series& a, const Series& b) {
  if (a.times != b.times) throw InputError("the two columns have no values at the same times");
  Series result = a;
  for (std::size_t i = 0; i < a.values.size(); ++i) result.values[i] -= b.values[i];
  return result;
}

}  // namespace washtub
