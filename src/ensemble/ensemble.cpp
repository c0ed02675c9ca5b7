#include "ensemble/ensemble.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/error.hpp"
#include "ensemble/members.hpp"
#include "io/file.hpp"
#include "record/columns.hpp"

namespace washtub {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

namespace {

constexpr const char* list = "ensemble.json";
constexpr const char* seeds_key = "seeds";
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr double wanted = 0.05;  // half width, of the mean

std::string list_path(const std::string& directory) {
  return (fs::path(directory) / list).string();
}

void foresee(PooledQuantity& quantity) {
  const double width = wanted * std::abs(quantity.pool.mean);
  quantity.seeds_wanted = count_for(quantity.pool.deviation, width);
  quantity.cycles_wanted = unknown;
  if (!quantity.pool.covered()) return;
  Statistics variances;  // of blocks
  for (const auto& batches : quantity.batches) {
    Statistics own;
    for (const double value : blocks(batches, quantity.pool.block)) own.add(value);
    if (own.weight() < 2) continue;
    variances.add(own.deviation() * own.deviation() * own.weight() / (own.weight() - 1));
  }
  quantity.cycles_wanted =
      static_cast<double>(quantity.pool.block) * count_for(std::sqrt(variances.mean()), width);
}

/// What tells runs that start alike: the seed of the first group of cloth.
std::uint64_t start_of(const RunRecord& run, std::uint64_t member) {
  return run.definition && !run.definition->cloth.empty() ? run.definition->cloth[0].seed : member;
}

/// The quantities in the order in which the members name them.
std::vector<PooledQuantity> pool_all(const std::vector<std::uint64_t>& seeds,
                                     const std::vector<RunRecord>& runs) {
  std::vector<PooledQuantity> all;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (RunQuantity& own : find_quantities(runs[i])) {
      auto at = std::find_if(all.begin(), all.end(),
                             [&](const auto& known) { return known.about.name == own.name; });
      if (at == all.end()) {
        all.emplace_back();
        at = all.end() - 1;
        at->about = own;
        at->about.batches.clear();
      }
      at->about.seeds.push_back(start_of(runs[i], seeds[i]));
      at->about.batches.push_back(own.mean);
      at->batches.push_back(std::move(own.batches));
    }
  for (PooledQuantity& quantity : all) {
    quantity.pool = pool(quantity.about.batches, quantity.batches);
    quantity.drift = drift(quantity.batches);
    quantity.about.mean = quantity.pool.mean;
    foresee(quantity);
  }
  return all;
}

/// Names of the groups of cloth, where there are several.
Json groups_of(const Ensemble& ensemble) {
  Json names = Json::array();
  if (const auto& definition = ensemble.runs.front().definition)
    for (const ClothCase& group : groups_apart(*definition)) names.push_back(group.name);
  return names;
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

}  // namespace

Ensemble::Ensemble(std::string where, std::vector<std::uint64_t> which,
                   std::vector<RunRecord> records)
    : directory(std::move(where)),
      seeds(std::move(which)),
      runs(std::move(records)),
      quantities(pool_all(seeds, runs)) {
  const fs::path path = fs::absolute(directory).lexically_normal();
  name = (path.has_filename() ? path : path.parent_path()).filename().string();
}

bool is_ensemble(const std::string& directory) { return fs::exists(list_path(directory)); }

void write_members(const std::string& directory, const std::vector<std::uint64_t>& seeds) {
  replace_file(list_path(directory), Json{{"version", 1}, {seeds_key, seeds}}.dump(2) + '\n');
}

Ensemble read_ensemble(const std::string& directory) {
  const Json json = Json::parse(read_file(list_path(directory)), nullptr, false);
  std::vector<std::uint64_t> seeds, found;
  if (json.is_object() && json.contains(seeds_key) && json[seeds_key].is_array())
    for (const Json& seed : json[seeds_key])
      if (seed.is_number_unsigned()) seeds.push_back(seed.get<std::uint64_t>());
  if (seeds.empty())
    throw InputError(
        fmt::format("{}: is damaged; washtub ensemble writes it anew", list_path(directory)));
  std::vector<RunRecord> runs;
  std::vector<std::uint64_t> missing;
  for (const std::uint64_t seed : seeds) {
    const std::string member = (fs::path(directory) / member_name(seed)).string();
    std::error_code none;
    missing.push_back(seed);
    if (!fs::exists(fs::path(member) / "summary.json", none)) continue;
    RunRecord run = read_run(member);
    if (outcome(run) != "complete" || !run.definition || !run.history) continue;
    missing.pop_back();
    found.push_back(seed);
    runs.push_back(std::move(run));
  }
  if (runs.empty())
    throw InputError(fmt::format(
        "{}: none of its {} members has reached its end; washtub ensemble goes on with them",
        directory, seeds.size()));
  Ensemble ensemble(directory, std::move(found), std::move(runs));
  ensemble.missing = std::move(missing);
  return ensemble;
}

Compared compared(Ensemble&& ensemble) {
  if (ensemble.runs.size() == 1) return Compared(std::move(ensemble.runs.front()));
  std::vector<RunQuantity> quantities;
  for (PooledQuantity& quantity : ensemble.quantities)
    quantities.push_back(std::move(quantity.about));
  const std::size_t members = ensemble.runs.size();
  return {ensemble.directory, ensemble.name, std::move(ensemble.runs.front()),
          std::move(quantities), members};
}

Json to_json(const Ensemble& ensemble) {
  Json rows = Json::array();
  for (const PooledQuantity& q : ensemble.quantities)
    rows.push_back({{"name", q.about.name},
                    {"unit", q.about.unit},
                    {"meaning", q.about.meaning},
                    {"mean", q.pool.mean},
                    {"half_width", number(q.pool.half_width)},
                    {"half_width_within", number(q.pool.within)},
                    {"deviation", number(q.pool.deviation)},
                    {"variance_ratio", number(q.pool.ratio)},
                    {"chance", number(q.pool.chance)},
                    {"cycles_per_block", q.pool.block},
                    {"members_told", q.pool.told},
                    {"members_that_hold_the_mean", q.pool.hold},
                    {"drift", number(q.drift.change)},
                    {"drift_half_width", number(q.drift.half_width)},
                    {"seeds_for_5_percent", number(q.seeds_wanted)},
                    {"cycles_for_5_percent", number(q.cycles_wanted)},
                    {"seeds", q.about.seeds},
                    {"members", q.about.batches}});
  const auto members = static_cast<double>(ensemble.runs.size());
  return {{"name", ensemble.name},
          {"seeds", ensemble.seeds},
          {"missing", ensemble.missing},
          {"groups", groups_of(ensemble)},
          {"student", members > 1 ? Json(student_95(members - 1)) : Json()},
          {"rows", rows},
          {"sentences", sentences(ensemble)}};
}

Json pooled_json(const Ensemble& ensemble) {
  Json all = {
      {"seeds", ensemble.seeds}, {"missing", ensemble.missing}, {"sentences", sentences(ensemble)}};
  for (const PooledQuantity& q : ensemble.quantities) {
    const std::string unit = q.about.unit.empty() ? "" : " [" + q.about.unit + "]";
    Json& entry = all[q.about.name];
    entry = {{"mean" + unit, q.pool.mean},
             {"95 % half width" + unit, number(q.pool.half_width)},
             {"95 % half width by cycles" + unit, number(q.pool.within)},
             {"standard deviation of members" + unit, number(q.pool.deviation)},
             {"members" + unit, q.about.batches},
             {"seeds", q.about.seeds},
             {"variance of members over what cycles let expect", number(q.pool.ratio)},
             {"chance of that or more", number(q.pool.chance)},
             {"cycles that count as one", q.pool.block},
             {"members with an interval", q.pool.told},
             {"members whose interval holds the mean", q.pool.hold},
             {"drift over the window" + unit, number(q.drift.change)},
             {"drift, 95 % half width" + unit, number(q.drift.half_width)},
             {"seeds for 5 %", number(q.seeds_wanted)},
             {"cycles for 5 %", number(q.cycles_wanted)}};
    if (q.about.scale_name.empty()) continue;
    const std::string scaled = " / " + q.about.scale_name;
    entry["mean" + scaled] = q.pool.mean / q.about.scale;
    entry["95 % half width" + scaled] = number(q.pool.half_width / q.about.scale);
  }
  return all;
}

}  // namespace washtub
