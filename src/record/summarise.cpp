#include "record/summarise.hpp"

#include <fmt/ranges.h>

#include <numeric>

#include "record/columns.hpp"
#include "record/names.hpp"
#include "record/quantities.hpp"

namespace washtub {

using Json = nlohmann::ordered_json;

namespace {

/// The entries of one table; those without a scale of their own are left out.
template <class Source>
Json table(const std::vector<DeclaredEntry<Source>>& declared, const Source& source,
           int dimension) {
  Json json = Json::object();
  for (const auto& entry : declared) {
    Json value = entry.take(source);
    if (entry.about.applies(dimension) && !value.is_null())
      json[entry_name(entry.about, dimension)] = std::move(value);
  }
  return json;
}

/// Statistics of what has a name: with their scale, and those of cycles one by one.
Json named_table(const std::string& name, const std::vector<RunQuantity>& quantities) {
  Json json = {{"name", name}};
  for (const RunQuantity& q : quantities) {
    const std::string unit = q.unit.empty() ? "" : " [" + q.unit + "]";
    if (q.name == names::energy) {
      json[q.name + unit] = q.batches;
      json["mean " + q.name + unit] = q.mean;
      const auto half_width = q.half_width();
      json[q.name + ", 95 % half width" + unit] = half_width ? Json(*half_width) : Json();
      continue;
    }
    json[q.name + unit] = q.mean;
    if (!q.scale_name.empty()) json[q.name + " / " + q.scale_name] = q.mean / q.scale;
  }
  return json;
}

/// Of each of several groups, its mean stress with the half width of that.
Json group_tables(const Case& whole, const CsvTable& history) {
  Json groups = Json::array();
  for (const ClothCase& group : groups_apart(whole)) {
    const auto quantities = group_quantities(whole, group, history);
    Json json = named_table(group.name, quantities);
    json["pieces"] = group.count;
    for (const RunQuantity& q : quantities)
      if (q.name == names::stress) {
        const auto half_width = q.half_width();
        json[q.name + ", 95 % half width [Pa]"] = half_width ? Json(*half_width) : Json();
      }
    groups.push_back(std::move(json));
  }
  return groups;
}

Json cloth_table(const Case& whole, const ClothStatistics& statistics, const CsvTable& history,
                 const CsvTable* tracks) {
  const ClothStatistics::Part all = statistics.all();
  const auto scale = scales(whole);
  const auto stress = [&](const StressSummary& part) {
    return table(entries::stress, StressSource{part, scale}, whole.dimension);
  };
  const ClothSource source{whole, statistics, all, history};
  Json json = table(entries::cloth, source, whole.dimension);
  json[names::stress] = stress(all.stress.total());
  json[names::membrane_stress] = stress(all.stress.membrane());
  json[names::bending_stress] = stress(all.stress.bending());
  for (const RunQuantity& q : cloth_quantities(whole, history))
    if (!json.contains(q.name)) json[q.name + (q.unit.empty() ? "" : " [" + q.unit + "]")] = q.mean;
  if (const Json groups = group_tables(whole, history); !groups.empty()) json["groups"] = groups;
  if (whole.dimension == 3 && tracks)
    json["loop"] = table(entries::loop, LoopSource(whole, *tracks), whole.dimension);
  return json;
}

}  // namespace

std::string entry_name(const Declared& about, int dimension) {
  const std::string unit = about.unit.in(dimension);
  return unit.empty() ? about.name : std::string(about.name) + " [" + unit + "]";
}

std::string phases_text(const PhaseTimes& times) {
  const double all = std::accumulate(times.begin(), times.end(), 0.0);
  std::vector<std::string> parts;
  for (std::size_t p = 0; p < times.size(); ++p)
    if (times[p] > 0)
      parts.push_back(fmt::format("{} {:.3g} s ({:.0f} %)", entries::phases[2 * p].about.name,
                                  times[p], 100 * times[p] / all));
  return fmt::format("{}", fmt::join(parts, ", "));
}

LoopSource::LoopSource(const Case& whole, const CsvTable& tracks)
    : map(whole.scale.length > 0 ? whole.scale.length : 1, whole.scale.height) {
  const auto& times = tracks.columns()[0].values;
  const Interval span = WindowedHistory(whole, tracks).averaging().over;
  const double slack = 1e-9 * span.end;
  std::vector<std::size_t> rows;
  for (std::size_t i = 0; i < times.size(); ++i)
    if (times[i] >= span.begin - slack && times[i] <= span.end + slack) rows.push_back(i);
  std::vector<double> within;
  for (const std::size_t i : rows) within.push_back(times[i]);
  const int pieces = piece_count(whole);
  for (int p = 1; p <= pieces && rows.size() > 1; ++p) {
    const auto& r = tracks.column(piece_column(p, names::piece_r)).values;
    const auto& z = tracks.column(piece_column(p, names::piece_z)).values;
    std::vector<Vec<2>> track;
    for (const std::size_t i : rows) track.emplace_back(r[i], z[i]);
    map.add(within, track);
    const Loop around = loop(within, track);
    area += around.area / pieces;
    turns += around.turns / pieces;
  }
}

Json summarise(const Case& whole, const RunEnd& end, const ClothStatistics& cloth,
               const CsvTable& history, const CsvTable* tracks) {
  const Averaging span = WindowedHistory(whole, history).averaging();
  Json json = table(entries::top, TopSource{whole, span}, whole.dimension);
  const RunSource run{whole, end};
  json[names::run] = table(entries::run, run, whole.dimension);
  json[names::phases] = table(entries::phases, run, whole.dimension);
  if (!whole.cloth.empty()) json[names::coupling] = table(entries::coupling, run, whole.dimension);
  json["quality"] = table(entries::quality, run, whole.dimension);
  json[names::warnings] = end.quality.warnings(whole);
  if (const auto scale = scales(whole))
    json["scales"] = table(entries::scales, *scale, whole.dimension);
  json["solids"] = Json::array();
  for (const SolidCase& solid : whole.solids)
    json["solids"].push_back(named_table(solid.name, solid_quantities(whole, solid, history)));
  if (!whole.cloth.empty()) json[names::cloth] = cloth_table(whole, cloth, history, tracks);
  return json;
}

}  // namespace washtub
