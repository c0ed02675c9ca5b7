#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "ensemble/ensemble.hpp"

namespace washtub {
namespace {

using Quantities = std::vector<const PooledQuantity*>;

template <class Is>
Quantities where(const Ensemble& ensemble, const Is& is) {
  Quantities found;
  for (const PooledQuantity& quantity : ensemble.quantities)
    if (is(quantity)) found.push_back(&quantity);
  return found;
}

constexpr std::size_t most_named = 5;

/// "stress, membrane stress and 3 more"
std::string joined(std::vector<std::string> all) {
  if (all.size() > most_named + 1) {
    const std::size_t more = all.size() - most_named;
    all.resize(most_named);
    all.push_back(fmt::format("{} more", more));
  }
  std::string text;
  for (std::size_t i = 0; i < all.size(); ++i)
    text += (i == 0 ? "" : i + 1 == all.size() ? " and " : ", ") + all[i];
  return text;
}

std::string names_of(const Quantities& all) {
  std::vector<std::string> names;
  for (const auto* quantity : all) names.push_back(quantity->about.name);
  return joined(std::move(names));
}

bool is_alike(const PooledQuantity& q) {
  return !(q.pool.deviation > 1e-9 * std::abs(q.pool.mean));
}

std::string missing_sentence(const Ensemble& ensemble) {
  if (ensemble.missing.empty()) return "";
  std::vector<std::string> seeds;
  for (const auto seed : ensemble.missing) seeds.push_back(std::to_string(seed));
  return fmt::format(
      "Not all members have reached their end; left out: seed {}. Where those fail that are "
      "strained "
      "most, what is left is biased.",
      joined(std::move(seeds)));
}

std::size_t testable(const Ensemble& ensemble) {
  return where(ensemble, [](const auto& q) { return std::isfinite(q.pool.chance); }).size();
}

/// How many quantities seem significant at 95 % where none is.
double by_chance(const Ensemble& ensemble) {
  return std::round(0.05 * static_cast<double>(testable(ensemble)));
}

std::string cover_sentence(const Ensemble& ensemble) {
  const Quantities wider = where(ensemble, [](const auto& q) { return q.pool.not_covered(); });
  if (testable(ensemble) == 0)
    return "Whether the cycles of one run tell as much as other starts do cannot be told: the "
           "members have fewer than two whole cycles in the window.";
  if (wider.empty())
    return "The intervals of single runs cover the spread between them: nothing shows that their "
           "cycles tell less than other starts do.";
  const auto worst =
      *std::max_element(wider.begin(), wider.end(),
                        [](const auto* a, const auto* b) { return a->pool.ratio < b->pool.ratio; });
  return fmt::format(
      "The intervals of single runs are too narrow for {}: the members differ more than their "
      "cycles let expect ({} {:.2g} times). Trust the interval between the members there: what one "
      "start does lasts longer than its window, or for ever. (Of {} quantities about {:.0f} seem "
      "so "
      "by chance.)",
      names_of(wider), worst->about.name, std::sqrt(worst->pool.ratio), ensemble.quantities.size(),
      by_chance(ensemble));
}

std::string drift_sentence(const Ensemble& ensemble) {
  const Quantities moving = where(ensemble, [](const auto& q) {
    return q.drift.significant() && std::abs(q.drift.change) > 0.01 * std::abs(q.pool.mean);
  });
  if (moving.empty()) return "";
  std::vector<std::string> parts;
  for (const auto* q : moving)
    parts.push_back(
        fmt::format("{} {:+.0f} %", q->about.name, 100 * q->drift.change / std::abs(q->pool.mean)));
  return fmt::format(
      "From the first cycle of the window to the last these drift: {}. The window may begin too "
      "early; try new runs with a later output.window. (Of {} quantities about {:.0f} seem so by "
      "chance.)",
      joined(std::move(parts)), testable(ensemble), by_chance(ensemble));
}

/// Of the first quantity whose mean is known and not 0.
std::string wanted_sentence(const Ensemble& ensemble) {
  const Quantities known = where(
      ensemble, [](const auto& q) { return std::isfinite(q.pool.half_width) && q.pool.mean != 0; });
  if (known.empty()) return "";
  const PooledQuantity& q = *known.front();
  const double now = 100 * q.pool.half_width / std::abs(q.pool.mean);
  const std::string text =
      fmt::format("{} is known to within {:.{}f} %", q.about.name, now, now < 10 ? 1 : 0);
  if (now <= 5) return text + '.';
  const auto count = [](double n) {
    return n >= 1e6 ? "over a million" : fmt::format("{:.0f}", n);
  };
  return fmt::format("{}; 5 % take about {} members{}.", text, count(q.seeds_wanted),
                     std::isfinite(q.cycles_wanted)
                         ? fmt::format(", or one run of {} cycles", count(q.cycles_wanted))
                         : "");
}

}  // namespace

std::vector<std::string> sentences(const Ensemble& ensemble) {
  if (ensemble.runs.size() < 2)
    return {"Only one member has reached its end: what starts differ by cannot be told."};
  if (ensemble.quantities.empty()) return {"The members have no statistics."};
  if (where(ensemble, is_alike).size() == ensemble.quantities.size())
    return {"All members are the same: nothing in this case depends on the seed."};
  std::vector<std::string> all;
  for (std::string text : {missing_sentence(ensemble), cover_sentence(ensemble),
                           drift_sentence(ensemble), wanted_sentence(ensemble)})
    if (!text.empty()) all.push_back(std::move(text));
  return all;
}

}  // namespace washtub
