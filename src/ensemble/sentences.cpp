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

bool is_known(const PooledQuantity& q) { return std::isfinite(q.pool.half_width); }

bool is_alike(const PooledQuantity& q) {
  return !(q.pool.deviation > 1e-9 * std::abs(q.pool.mean));
}

std::string cover_sentence(const Ensemble& ensemble) {
  const Quantities wider = where(ensemble, [](const auto& q) { return q.pool.not_covered(); });
  if (wider.empty())
    return "The intervals of single runs cover the spread between them: their cycles tell as much "
           "as other starts do.";
  const auto worst =
      *std::max_element(wider.begin(), wider.end(),
                        [](const auto* a, const auto* b) { return a->pool.ratio < b->pool.ratio; });
  const auto all = static_cast<double>(ensemble.quantities.size());
  return fmt::format(
      "The intervals of single runs are too narrow for {}: the members differ more than their "
      "cycles let expect ({} {:.2g} times). Trust the interval between the members there; longer "
      "runs of one start do not replace it. (Of {} quantities about {:.0f} seem so by chance.)",
      names_of(wider), worst->about.name, std::sqrt(worst->pool.ratio), all, std::ceil(0.05 * all));
}

std::string drift_sentence(const Ensemble& ensemble) {
  const Quantities moving = where(ensemble, [](const auto& q) {
    return q.drift.significant() && std::abs(q.drift.change) > 0.01 * std::abs(q.pool.mean);
  });
  if (moving.empty()) return "";
  std::vector<std::string> parts;
  for (const auto* q : moving)
    parts.push_back(
        fmt::format("{} {:+.2g} %", q->about.name, 100 * q->drift.change / std::abs(q->pool.mean)));
  return fmt::format(
      "From the first cycle of the window to the last these drift: {}. The window may begin too "
      "early; try a later output.window.",
      joined(std::move(parts)));
}

std::string wanted_sentence(const Ensemble& ensemble) {
  const Quantities known = where(ensemble, is_known);
  if (known.empty()) return "";
  const auto* first = known.front();
  const auto& q = *first;
  const double now = 100 * q.pool.half_width / std::abs(q.pool.mean);
  std::string text =
      fmt::format("{} is known to within {:.2g} % now; to within 5 % takes about {:.0f} members",
                  q.about.name, now, q.seeds_wanted);
  if (std::isfinite(q.cycles_wanted))
    text += fmt::format(", or one run of about {:.0f} cycles in the window", q.cycles_wanted);
  return text + '.';
}

}  // namespace

std::vector<std::string> sentences(const Ensemble& ensemble) {
  if (ensemble.runs.size() < 2)
    return {"Only one member has reached its end: what starts differ by cannot be told."};
  if (ensemble.quantities.empty()) return {"The members have no statistics."};
  if (where(ensemble, is_alike).size() == ensemble.quantities.size())
    return {"All members are the same: nothing in this case depends on the seed."};
  std::vector<std::string> all = {cover_sentence(ensemble)};
  for (std::string text : {drift_sentence(ensemble), wanted_sentence(ensemble)})
    if (!text.empty()) all.push_back(std::move(text));
  return all;
}

}  // namespace washtub
