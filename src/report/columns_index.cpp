#include "report/columns_index.hpp"

#include "record/columns.hpp"
#include "record/names.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

/// "Torque on" and "tub" to "Torque on tub"; "" stays so.
std::string of(const std::string& text, const std::string& owner) {
  return text.empty() || owner.empty() ? text : text + ' ' + owner;
}

/// The name of a statistic follows its owner's.
std::string statistic(const std::string& owner, const std::string& name) {
  return name.empty() || owner.empty() ? name : owner + ' ' + name;
}

Json index_of(const CsvTable::Column& column, const KnownColumn& known, bool moving) {
  const auto& [owner, about, plot] = known;
  const std::string title = of(plot.title, owner);
  const char* scale = plot.scale == Scale::stress   ? "stress"
                      : plot.scale == Scale::torque ? "torque"
                                                    : "";
  return {{"name", column.name},
          {"meaning", about.meaning},
          {"fold", plot.fold},
          {"plot", title.empty() ? column.name : title},
          {"axis", *plot.axis ? plot.axis : column.name},
          {"curve", *plot.curve ? plot.curve : column.name},
          {"scale", scale},
          {"shown", plot.shown},
          {"logarithmic", plot.logarithmic},
          {"instants", plot.instants && !moving},
          {"statistic", statistic(owner, plot.statistic)},
          {"integral", of(plot.integral, owner)},
          {"integral_statistic", statistic(owner, plot.integral_statistic)}};
}

}  // namespace

Json columns_index(const CsvTable& history) {
  Json first = Json::array(), rest = Json::array();
  for (const auto& column : history.columns()) {
    const auto known = known_column(column.name);
    if (!known || !*known->plot.fold) continue;
    const bool moving =
        !known->owner.empty() && history.find(known->owner + ' ' + names::power) != nullptr;
    (moving ? first : rest).push_back(index_of(column, *known, moving));
  }
  first.insert(first.end(), rest.begin(), rest.end());
  return first;
}

}  // namespace washtub
