#include <algorithm>
#include <cmath>
#include <limits>

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

/// Where the time is too short for all cloth to sink through the box.
void note_slow(Case& whole, int dimension) {
  const SettleCase& settle = whole.settle;
  const double depth = whole.domain.size[dimension - 1];
  double lightest = std::numeric_limits<double>::infinity();
  for (const ClothCase& cloth : whole.cloth)
    if (cloth.count > 0) lightest = std::min(lightest, cloth.material.excess_mass);
  const double speed = std::sqrt(settle.gravity.norm() * lightest / whole.fluid.density);
  if (!(lightest > 0) || !std::isfinite(speed) || settle.time * speed >= 2 * depth) return;
  whole.notes.push_back(fmt::format(
      "the lightest cloth sinks broadside at {:.2g} m/s at most, through the box in {:.2g} s or "
      "more; settle.time is {:.3g} s: try a longer one or a larger settle.gravity",
      speed, depth / speed, settle.time));
}

}  // namespace

Table<SettleCase> settle_table() {
  Table<SettleCase> table(
      "Before t = 0 cloth may settle: it sinks through the water, which is still at first, while "
      "all solids rest, and lies on what is below it. Then the water is still again, and the run "
      "begins with the cloth as it lies. Loads do not pull meanwhile. Has no effect with `--from`; "
      "a run "
      "that is stopped meanwhile leaves nothing to go on from.");
  table
      .key("time", &SettleCase::time, quantity(measure::time, at_least(0)),
           "that this takes at most; it ends when the cloth moves at less than a twentieth of the "
           "speed at which it sinks")
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
  if (!find_key(root, "settle.gravity")) settle.gravity = file.result.fluid.gravity;
  if (settle.gravity.isZero() && !find_key(root, "settle.gravity"))
    settle.gravity[dimension - 1] = -usual_gravity;
  if (settle.time > 0) note_slow(file.result, dimension);
  const double then = file.result.fluid.gravity.norm();
  if (settle.time > 0 && then < 0.5 * settle.gravity.norm())
    file.result.notes.push_back(
        fmt::format("the cloth settles under {:.3g} m/s^2, but at t = 0 its weight becomes that of "
                    "{:.3g} m/s^2 (fluid.gravity), and what lies on each other parts",
                    settle.gravity.norm(), then));
}

void check_settle(const Case& whole, const Node& root) {
  if (whole.settle.time > 0 && whole.settle.gravity.isZero())
    throw error_at_key(root, "settle.gravity", "", "cloth settles under a gravity other than zero");
  if (whole.settle.time == 0 && !sinks(whole) && find_key(root, "settle.gravity"))
    throw error_at_key(root, "settle.gravity", "",
                       "expected settle.time along with it: no cloth settles in 0 s");
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
