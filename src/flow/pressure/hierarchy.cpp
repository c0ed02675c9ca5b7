#include "flow/pressure/hierarchy.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr double similar = 1.4;      // spacings within this ratio are coarsened together
constexpr long gather_below = 4096;  // cells under which a level is not worth distributing
constexpr long coarsest = 128;       // cells that a few sweeps solve well enough

template <int D>
long count(const Index<D>& cells) {
  long total = 1;
  for (const int n : cells) total *= n;
  return total;
}

/// Axes to be coarsened next: of those with more than one cell, the ones of finest spacing.
template <int D>
Index<D> choose_factor(const Index<D>& cells, const Vec<D>& h) {
  double finest = std::numeric_limits<double>::infinity();
  for (int d = 0; d < D; ++d)
    if (cells[d] > 1) finest = std::min(finest, h[d]);
  Index<D> factor;
  for (int d = 0; d < D; ++d) factor[d] = cells[d] > 1 && h[d] < similar * finest ? 2 : 1;
  return factor;
}

template <int D>
[[noreturn]] void refuse(const Mesh<D>& mesh) {
  std::string cells;
  for (const int n : mesh.cells) cells += (cells.empty() ? "" : " x ") + std::to_string(n);
  throw InputError(cells +
                   " cells are too few for the pressure solver; try 8 or more along every axis");
}

}  // namespace

template <int D>
std::vector<Coarsening<D>> coarsen(const Mesh<D>& mesh) {
  std::vector<Coarsening<D>> levels;
  Index<D> cells = mesh.cells;
  Vec<D> h = mesh.h;
  bool gathered = false;
  while ((cells[0] > 4 && cells[D - 1] > 2) || count<D>(cells) > coarsest) {
    const Index<D> factor = choose_factor<D>(cells, h);
    for (int d = 0; d < D; ++d) {
      cells[d] = coarse_count(cells[d], factor[d]);
      h[d] *= factor[d];
    }
    gathered = gathered || count<D>(cells) <= gather_below;
    levels.push_back({factor, cells, h, gathered});
  }
  if (levels.empty()) refuse(mesh);
  return levels;
}

template <int D>
Granularity<D> granularity(const Mesh<D>& mesh) {
  Granularity<D> unit;
  unit.fill(1);
  for (const auto& level : coarsen(mesh)) {
    for (int d = 0; d < D; ++d) unit[d] *= level.factor[d];
    if (level.gathered) break;
  }
  return unit;
}

template std::vector<Coarsening<2>> coarsen<2>(const Mesh<2>&);
template std::vector<Coarsening<3>> coarsen<3>(const Mesh<3>&);
template Granularity<2> granularity<2>(const Mesh<2>&);
template Granularity<3> granularity<3>(const Mesh<3>&);

}  // namespace washtub
