#include "grid/grid.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace washtub {

std::array<int, 2> cut_axis(int n, int unit, int parts, int part) {
  const int units = (n + unit - 1) / unit;  // the last one may be short
  const auto edge = [&](int p) {
    if (p == parts) return n;
    const double even = static_cast<double>(n) * p / (static_cast<double>(parts) * unit);
    const int nearest = static_cast<int>(std::lround(even));
    return unit * std::clamp(nearest, p, units - parts + p);
  };
  return {edge(part), edge(part + 1) - edge(part)};
}

/// Cells of the largest part.
int largest_part(int n, int unit, int parts) {
  int largest = 0;
  for (int p = 0; p < parts; ++p) largest = std::max(largest, cut_axis(n, unit, parts, p)[1]);
  return largest;
}

template <int D>
Index<D> choose_ranks(const Index<D>& cells, const Granularity<D>& unit, int size) {
  Index<D> best{};
  long best_cost = -1;
  for (int last = 1; last <= size; ++last) {
    if (size % last != 0) continue;
    Index<D> ranks;
    ranks.fill(1);
    ranks[D - 1] = last;
    if (D == 3) ranks[1] = size / last;
    if (D == 2 && last != size) continue;
    long volume = cells[0], surface = 0;
    bool fits = true;
    for (int d = 1; d < D; ++d) fits = fits && ranks[d] <= (cells[d] + unit[d] - 1) / unit[d];
    if (!fits) continue;
    for (int d = 1; d < D; ++d) {
      volume *= largest_part(cells[d], unit[d], ranks[d]);
      if (ranks[d] > 1) surface += 1;
    }
    const long cost = 16 * volume + surface * volume;
    if (best_cost < 0 || cost < best_cost) best = ranks, best_cost = cost;
  }
  if (best_cost < 0)
    throw InputError(std::to_string(size) + " ranks are too many for this grid: try fewer (-n)");
  return best;
}

template <int D>
Grid<D>::Grid(const Mesh<D>& mesh, const Parallel& parallel, const Granularity<D>& unit)
    : mesh_(mesh), parallel_(parallel), ranks_(choose_ranks<D>(mesh.cells, unit, parallel.size())) {
  std::array<int, D> periods{}, place{};
  for (int d = 1; d < D; ++d) periods[d - 1] = mesh.periodic[d];
  MPI_Cart_create(parallel.comm(), D - 1, ranks_.data() + 1, periods.data(), 0, &comm_);
  MPI_Cart_coords(comm_, parallel.rank(), D - 1, place.data());
  Index<D> offset{}, count = mesh.cells;
  for (int d = 1; d < D; ++d) {
    const auto [first, n] = cut_axis(mesh.cells[d], unit[d], ranks_[d], place[d - 1]);
    offset[d] = first;
    count[d] = n;
  }
  block_ = Block<D>(offset, count);
  halo_ = Halo<D>(comm_, block_, mesh.periodic[0]);
}

template <int D>
Grid<D>::~Grid() {
  if (comm_ != MPI_COMM_NULL) MPI_Comm_free(&comm_);
}

template <int D>
GridPart Grid<D>::part() const {
  GridPart part;
  part.memory[2] = static_cast<std::size_t>(block_.stride[1]);
  part.start = static_cast<std::size_t>(Block<D>::pad) - 1;
  for (int d = 0; d < D; ++d) {
    const auto a = static_cast<std::size_t>(2 - d);
    const int first = block_.offset[d], cells = block_.count[d], all = mesh_.cells[d];
    const bool lower = first == 0, upper = first + cells == all;
    part.extent[a] = static_cast<std::size_t>(all + 2);
    part.offset[a] = static_cast<std::size_t>(first + !lower);
    part.count[a] = static_cast<std::size_t>(cells + lower + upper);
    part.near[a] = static_cast<std::size_t>(first);
    part.near_count[a] = static_cast<std::size_t>(cells + 2);
    if (d > 0) part.memory[a] = part.near_count[a];
  }
  return part;
}

template Index<2> choose_ranks<2>(const Index<2>&, const Granularity<2>&, int);
template Index<3> choose_ranks<3>(const Index<3>&, const Granularity<3>&, int);
template class Grid<2>;
template class Grid<3>;

}  // namespace washtub
