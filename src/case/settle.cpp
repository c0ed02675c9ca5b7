#include <algorithm>

#include "case/tables.hpp"

namespace washtub {
namespace {

constexpr double usual_gravity = 9.81;  // [m/s^2]
constexpr double usual_time = 5;        // [s]

bool sinks(const Case& whole) {
  return std::any_of(whole.cloth.begin(), whole.cloth.end(), [](const ClothCase& cloth) {
    return cloth.arrangement == Arrangement::dropped;
  });
}

bool rests(const SettleCase& settle, int) { return settle.time <= 0; }

}  // namespace

Table<SettleCase> settle_table() {
  Table<SettleCase> table(
      "Before t = 0 cloth may settle: it sinks through the water, which is still at first, while "
      "all solids rest, and lies on what is below it. Then the water is still again, and the run "
      "begins with the cloth as it lies.");
  table
      .key("time", &SettleCase::time, quantity(measure::time, at_least(0)),
           "that this takes at most; it ends when the cloth has come to rest")
      .fallback("5 s where cloth is \"dropped\", else 0 s")
      .omitted(rests)
      .key("gravity", &SettleCase::gravity, vector(measure::acceleration),
           "that the cloth settles under")
      .fallback("`fluid.gravity`, or where that is zero 9.81 m/s^2 downwards (-z; in 2-D -y)")
      .omitted(rests);
  return table;
}

void complete_settle(CaseFile& file, const Node& root, int dimension) {
  SettleCase& settle = file.result.settle;
  if (settle.time < 0) settle.time = sinks(file.result) ? usual_time : 0;
  if (find_key(root, "settle.gravity")) return;
  settle.gravity = file.result.fluid.gravity;
  if (settle.gravity.isZero()) settle.gravity[dimension - 1] = -usual_gravity;
}

void check_settle(const Case& whole, const Node& root) {
  if (whole.settle.time > 0 && whole.settle.gravity.isZero())
    throw error_at_key(root, "settle.gravity", "", "cloth settles under a gravity other than zero");
  if (sinks(whole) && whole.settle.time == 0)
    throw error_at_key(root, "settle.time", "", "dropped cloth needs a time to settle in");
  const auto& groups = whole.cloth;
  for (size_t i = 0; i < groups.size(); ++i)
    if (groups[i].arrangement == Arrangement::dropped && groups[i].material.excess_mass == 0)
      throw error_at_key(root, cloth_key(i, groups.size(), "excess_mass"), "\"0 kg/m^2\"",
                         "cloth that weighs no more than water does not sink; allowed for "
                         "arrangement \"dropped\": above 0 kg/m^2");
}

}  // namespace washtub
