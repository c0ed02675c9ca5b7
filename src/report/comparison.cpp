#include "report/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.hpp"
#include "measure/pool.hpp"
#include "report/settings.hpp"

namespace washtub {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

/// The last parts of a path, "fast/wash" for two of them.
std::string last_parts(const std::string& directory, int count) {
  fs::path path = fs::absolute(directory).lexically_normal(), result;
  if (!path.has_filename()) path = path.parent_path();
  for (; count > 0 && path.has_filename(); --count, path = path.parent_path())
    result = result.empty() ? path.filename() : path.filename() / result;
  return result.empty() ? directory : result.string();
}

bool all_differ(const std::vector<Compared>& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (all[i].name == all[j].name) return false;
  return true;
}

const RunQuantity* named(const std::vector<RunQuantity>& quantities, const std::string& name) {
  for (const RunQuantity& quantity : quantities)
    if (quantity.name == name) return &quantity;
  return nullptr;
}

/// Largest of what the mean is made of.
double magnitude(const RunQuantity& quantity) {
  double largest = std::abs(quantity.mean);
  for (const double value : quantity.batches) largest = std::max(largest, std::abs(value));
  return largest;
}

/// The means of the runs of two ensembles in the order of their seeds; none where they have not all
/// the same.
struct Paired {
  std::vector<double> first, other;
};

Paired pairs(const RunQuantity& first, const RunQuantity& other) {
  Paired result;
  for (std::size_t i = 0; i < first.seeds.size(); ++i)
    for (std::size_t j = 0; j < other.seeds.size(); ++j)
      if (first.seeds[i] == other.seeds[j]) {
        result.first.push_back(first.batches[i]);
        result.other.push_back(other.batches[j]);
      }
  const std::size_t common = result.first.size();
  return common == first.seeds.size() && common == other.seeds.size() ? result : Paired();
}

std::optional<AgainstFirst> against(const std::optional<RunQuantity>& first,
                                    const std::optional<RunQuantity>& other) {
  constexpr double rounding = 1e-6;  // the files hold nine digits, and sums round differently
  if (!first || !other) return {};
  AgainstFirst result;
  const Paired both = pairs(*first, *other);
  result.paired = both.first.size() > 1;
  const DifferenceEstimate estimate = result.paired
                                          ? paired(both.first, both.other)
                                          : welch(first->independent(), other->independent());
  const double difference = other->mean - first->mean;
  if (std::abs(difference) > rounding * std::max(magnitude(*first), magnitude(*other)))
    result.difference = difference;
  result.relative = std::abs(first->mean) > rounding * magnitude(*first);
  if (result.relative) result.percent = 100 * result.difference / std::abs(first->mean);
  if (std::isfinite(estimate.half_width)) result.half_width = estimate.half_width;
  return result;
}

/// Rows in the order in which the runs name their quantities, the first run's first.
std::vector<CompareRow> rows_of(const std::vector<Compared>& all) {
  std::vector<CompareRow> rows;
  for (const Compared& one : all)
    for (const RunQuantity& quantity : one.quantities) {
      const auto known = [&](const CompareRow& row) { return row.name == quantity.name; };
      if (std::any_of(rows.begin(), rows.end(), known)) continue;
      CompareRow row{quantity.name, quantity.unit, {}, {}};
      for (const Compared& other : all) {
        const RunQuantity* value = named(other.quantities, row.name);
        row.values.push_back(value ? std::optional(*value) : std::nullopt);
        row.against.push_back(
            row.values.size() == 1 ? std::nullopt : against(row.values.front(), row.values.back()));
      }
      rows.push_back(std::move(row));
    }
  return rows;
}

/// Two digits, and none after the point from ten on.
std::string rough(double percent) {
  return percent < 9.95 ? fmt::format("{:.2g}", percent) : fmt::format("{:.0f}", percent);
}

/// A difference in per cent of the first run's value, or in the quantity's unit where that is 0.
struct Difference {
  double value = 0;
  std::optional<double> width;
  std::string unit;

  /// "12.0 %"
  std::string text() const {
    const double size = std::abs(value);
    return fmt::format("{} {}", width ? as_exact(size, width) : rough(size), unit);
  }
  /// "-3.1 % to +8.2 %"; for how much lower it is without signs and the other way round.
  std::string interval(bool with_sign) const {
    const double middle = with_sign ? value : std::abs(value);
    const auto end = [&](double at) {
      return fmt::format("{}{}", with_sign && at > 0 ? "+" : "", as_exact(at, width));
    };
    return fmt::format("{} {} to {} {}", end(middle - *width), unit, end(middle + *width), unit);
  }
};

Difference shown(const AgainstFirst& difference, const CompareRow& row) {
  if (!difference.relative) return {difference.difference, difference.half_width, row.unit};
  Difference result{difference.percent, {}, "%"};
  if (difference.half_width)
    result.width = 100 * *difference.half_width / std::abs(row.values[0]->mean);
  return result;
}

/// What keeps a difference from being told: too short a window, or too few members.
std::string reason(const CompareRow& row, std::size_t run, const std::vector<std::string>& names) {
  const auto few = [&](std::size_t i) { return row.values[i]->batches.size() < 2; };
  if (few(0) && few(run))
    return fmt::format("{} and {} have it for fewer than two whole cycles or runs", names[0],
                       names[run]);
  return fmt::format("{} has it for fewer than two whole cycles or runs", names[few(0) ? 0 : run]);
}

std::string difference_sentence(const CompareRow& row, std::size_t run,
                                const std::vector<std::string>& names) {
  const auto& values = row.values;
  const std::string &first = names[0], &other = names[run];
  if (!values[0] && !values[run]) return "";
  if (!values[0] || !values[run])
    return fmt::format("{}: not known for {}.", row.name, values[0] ? other : first);
  const AgainstFirst& difference = *row.against[run];
  const Difference text = shown(difference, row);
  const char* way = difference.difference > 0 ? "higher" : "lower";
  if (difference.difference == 0)
    return fmt::format("{}: the same in {} and {}.", row.name, other, first);
  if (!difference.significant())
    return fmt::format(
        "{}: {} {} in {} than in {}, but whether that is chance cannot be "
        "told, {}.",
        row.name, text.text(), way, other, first, reason(row, run, names));
  if (!*difference.significant())
    return fmt::format(
        "{}: no significant difference, {} {} {} in {} than in {} may be chance (95 % interval "
        "{}).",
        row.name, rough(std::abs(text.value)), text.unit, way, other, first, text.interval(true));
  return fmt::format("{}: {} {} in {} than in {} (95 % interval {}).", row.name, text.text(), way,
                     other, first, text.interval(false));
}

constexpr const char* meaning =
    "A difference is called significant where its 95 % interval leaves out zero: about one in "
    "twenty such differences appears by chance where there is none.";
constexpr const char* of_runs =
    "The intervals come from the cycles of one run each, without a drive from eighths of its "
    "window. "
    "They do not tell how much the result "
    "depends on where the cloth starts; washtub ensemble does.";
constexpr const char* of_ensembles =
    "The intervals come from the spread between runs with other seeds; where both ensembles have "
    "the same seeds, from the differences of the runs that start alike.";

std::string closing(const std::vector<Compared>& all) {
  const auto is_ensemble = [](const Compared& one) { return one.members > 1; };
  const auto ensembles = std::count_if(all.begin(), all.end(), is_ensemble);
  if (ensembles == 0) return of_runs;
  if (ensembles == static_cast<long>(all.size())) return of_ensembles;
  return "Ensembles are held against single runs here: the intervals of those come from their own "
         "cycles and may be too narrow.";
}

}  // namespace

std::string as_exact(double value, std::optional<double> width) {
  if (!width || !(*width > 0)) return fmt::format("{:.4g}", value);
  const int places = 1 - static_cast<int>(std::floor(std::log10(*width)));
  const double size = std::max(std::abs(value), *width);
  const double last = std::pow(10.0, std::max(0, -places));
  const double whole = last > 1 ? std::round(value / last) * last : value;
  if (size < 1e6 && size >= 1e-3) return fmt::format("{:.{}f}", whole, std::clamp(places, 0, 9));
  const int digits = static_cast<int>(std::floor(std::log10(size))) + places;
  return fmt::format("{:.{}e}", value, std::clamp(digits, 1, 9));
}

std::optional<bool> AgainstFirst::significant() const {
  if (!half_width) return {};
  return difference != 0 && std::abs(difference) > *half_width;
}

Compared::Compared(RunRecord single)
    : directory(single.directory),
      name(single.name),
      run(std::move(single)),
      quantities(find_quantities(run)) {}

Compared::Compared(std::string where, std::string called, RunRecord first,
                   std::vector<RunQuantity> pooled, std::size_t count)
    : directory(std::move(where)),
      name(std::move(called)),
      run(std::move(first)),
      quantities(std::move(pooled)),
      members(count) {
  run.name = name + ", " + run.name;
}

void prepare_comparison(std::vector<Compared>& all) {
  if (all.size() < 2)
    throw InputError("a comparison needs two directories or more, as in washtub compare A B");
  for (std::size_t i = 1; i < all.size(); ++i) {
    const Compared& one = all[i];
    std::error_code error;
    for (std::size_t j = 0; j < i; ++j)
      if (fs::equivalent(one.directory, all[j].directory, error))
        throw InputError(fmt::format("{} and {} are the same directory; name each run once",
                                     all[j].directory, one.directory));
    const auto first = known_dimension(all[0].run), other = known_dimension(one.run);
    if (first && other && *first != *other)
      throw InputError(
          fmt::format("{} is {}-D and {} is {}-D: their quantities have different units; compare "
                      "runs of one dimension",
                      all[0].directory, *first, one.directory, *other));
  }
  for (int parts = 2; !all_differ(all) && parts < 100; ++parts)
    for (Compared& one : all) one.name = last_parts(one.directory, parts);
  for (Compared& one : all)
    if (one.members == 1) one.run.name = one.name;
}

RunComparison compare(const std::vector<Compared>& all) {
  RunComparison result;
  std::vector<const RunRecord*> runs;
  for (const Compared& one : all) {
    result.names.push_back(one.name);
    runs.push_back(&one.run);
  }
  result.rows = rows_of(all);
  result.sentences = differing_settings(runs);
  if (std::all_of(all.begin(), all.end(), [](const Compared& one) { return one.members > 1; }))
    std::erase_if(result.sentences, [](const std::string& sentence) {
      return sentence.substr(0, sentence.find(':')).ends_with(".seed");
    });
  for (std::size_t run = 1; run < runs.size(); ++run)
    for (const CompareRow& row : result.rows) {
      std::string sentence = difference_sentence(row, run, result.names);
      if (!sentence.empty()) result.sentences.push_back(std::move(sentence));
    }
  for (const RunRecord* run : runs)
    if (outcome(*run) != "complete")
      result.sentences.push_back(
          fmt::format("{} did not reach its end: {}.", run->name, outcome(*run)));
  if (result.rows.empty()) result.sentences.emplace_back("The runs have no statistics to compare.");
  result.sentences.emplace_back(meaning);
  result.sentences.push_back(closing(all));
  return result;
}

Json to_json(const RunComparison& comparison) {
  Json rows = Json::array();
  for (const CompareRow& row : comparison.rows) {
    Json values = Json::array(), differences = Json::array();
    for (const auto& value : row.values) values.push_back(value ? to_json(*value) : Json());
    for (const auto& d : row.against) {
      differences.push_back(nullptr);
      if (!d) continue;
      const auto significant = d->significant();
      differences.back() = {{"difference", d->difference},
                            {"half_width", d->half_width ? Json(*d->half_width) : Json()},
                            {"percent", d->percent},
                            {"significant", significant ? Json(*significant) : Json()},
                            {"paired", d->paired}};
    }
    rows.push_back({{"name", row.name},
                    {"unit", row.unit},
                    {"values", values},
                    {"against_first", differences}});
  }
  return {{"names", comparison.names}, {"rows", rows}, {"sentences", comparison.sentences}};
}

}  // namespace washtub
