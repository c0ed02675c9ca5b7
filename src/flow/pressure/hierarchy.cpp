#include "flow/pressure/hierarchy.hpp"

#include <string>

#include "base/error.hpp"

namespace washtub {
namespace {

constexpr double similar = 1.4;      // spacings within this ratio are coarsened together
constexpr long gather_below = 4096;  // cells under which a level is not worth distributing

template <int D>
[[noreturn]] void refuse(const Mesh<D>& mesh) {
  std::string cells;
  for (const int n : mesh.cells) cells += (cells.empty() ? "" : " x ") + std::to_string(n);
  throw InputError(cells +
                   " cells: the pressure solver must halve them along the axes of finest spacing; "
                   "try multiples of 16");
}

}  // namespace

template <int D>
std::vector<Coarsening<D>> coarsen(const Mesh<D>& mesh) {
  std::vector<Coarsening<D>> levels;
  Index<D> cells = mesh.cells;
  Vec<D> h = mesh.h;
  bool gathered = false;
  while (cells[0] > 4 && cells[D - 1] > 2) {
    Index<D> factor;
    long total = 1;
    bool any = false;
    const double finest = h.minCoeff();
    for (int d = 0; d < D; ++d) {
      factor[d] = (h[d] < similar * finest && cells[d] % 2 == 0 && cells[d] > 2) ? 2 : 1;
      any = any || factor[d] == 2;
    }
    if (!any) break;
    for (int d = 0; d < D; ++d) {
      cells[d] /= factor[d];
      h[d] *= factor[d];
      total *= cells[d];
    }
    gathered = gathered || total <= gather_below;
    levels.push_back({factor, cells, h, gathered});
  }
  if (levels.empty() || !levels.back().gathered) refuse(mesh);
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
