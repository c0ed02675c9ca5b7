#include "app/ranks.hpp"

#include <fmt/format.h>

#include "app/launch.hpp"
#include "base/cores.hpp"
#include "base/error.hpp"
#include "washer/build.hpp"

namespace washtub {
namespace {

/// Whether the grid can be cut for so many ranks.
template <int D>
bool can_cut(const Case& whole, int ranks) {
  const auto mesh = build_mesh<D>(whole);
  try {
    choose_ranks<D>(mesh.cells, granularity(mesh), ranks);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

bool can_cut(const Case& whole, int ranks) {
  return whole.dimension == 3 ? can_cut<3>(whole, ranks) : can_cut<2>(whole, ranks);
}

/// The largest number up to `ranks` that the grid can be cut for.
int as_cut(const Case& whole, int ranks) {
  while (ranks > 1 && !can_cut(whole, ranks)) --ranks;
  return ranks;
}

}  // namespace

RankChoice choose_ranks(std::optional<int> asked, const Case& whole) {
  if (asked && *asked < 1) throw InputError(fmt::format("-n {}: allowed: 1 or more ranks", *asked));
  if (asked && !can_cut(whole, *asked))
    throw InputError(fmt::format("-n {}: this grid cannot be cut for so many ranks; try -n {}",
                                 *asked, as_cut(whole, *asked)));
  if (asked) return {*asked, ""};
  const int cores = physical_cores(), most = as_cut(whole, cores);
  if (most == 1) return {};
  const int ranks = as_cut(whole, free_ranks(cores, busy_cores()));
  if (ranks == most) return {ranks, ""};
  return {ranks, fmt::format(
                     "other programs use some of the {} cores, so {} taken; -n {} takes all", cores,
                     ranks == 1 ? "one rank is" : fmt::format("{} ranks are", ranks), most)};
}

}  // namespace washtub
