#include "flow/pressure/components.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace washtub {
namespace {

template <int D, class Visit>
void for_live_cells(const Level<D>& l, Visit&& visit) {
  for (int k = 0; k < l.block.planes(); ++k)
    for (int j = 0; j < l.block.rows(); ++j) {
      const auto row = row_of(l, j, k);
      for (int i = row.begin; i < row.end; ++i)
        if (l.inverse_diagonal[row.p + i] > 0) visit(row.p + i, j, k, i);
    }
}

/// Smallest label among a cell and its open neighbours.
template <int D>
double neighbour_label(const Level<D>& l, const Storage<double>& label, long p) {
  double least = label[p];
  for (int d = 0; d < D; ++d) {
    const long s = l.block.stride[d];
    if (l.open[d][p] > 0) least = std::min(least, label[p - s]);
    if (l.open[d][p + s] > 0) least = std::min(least, label[p + s]);
  }
  return least;
}

/// Labels every live cell with the smallest cell number of its region.
template <int D>
Storage<double> label_components(const Grid<D>& grid, const Level<D>& l) {
  Storage<double> label = grid.make_field();
  const auto& n = grid.mesh().cells;
  for_live_cells(l, [&](long p, int j, int k, int i) {
    const auto c = l.block.row_cell(j, k);
    label[p] =
        i + static_cast<double>(n[0]) * (D == 3 ? c[1] + static_cast<double>(n[1]) * c[2] : c[1]);
  });
  bool changed = true;
  while (changed) {
    changed = false;
    l.halo.exchange(label.data());
    bool local = true;
    while (local) {
      local = false;
      for_live_cells(l, [&](long p, int, int, int) {
        const double least = neighbour_label(l, label, p);
        if (least < label[p]) label[p] = least, local = changed = true;
      });
    }
    changed = grid.parallel().any(changed);
  }
  return label;
}

struct Sum {
  double source = 0, cells = 0;
};

/// Adds up the sums of all ranks per label.
void merge(const Parallel& parallel, std::map<double, Sum>& sums) {
  std::vector<double> mine;
  for (const auto& [label, s] : sums) mine.insert(mine.end(), {label, s.source, s.cells});
  std::vector<int> sizes(static_cast<std::size_t>(parallel.size())), starts(sizes.size());
  int size = static_cast<int>(mine.size()), total = 0;
  MPI_Allgather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, parallel.comm());
  for (std::size_t r = 0; r < sizes.size(); ++r) starts[r] = total, total += sizes[r];
  std::vector<double> all(static_cast<std::size_t>(total));
  MPI_Allgatherv(mine.data(), size, MPI_DOUBLE, all.data(), sizes.data(), starts.data(), MPI_DOUBLE,
                 parallel.comm());
  sums.clear();
  for (std::size_t i = 0; i < all.size(); i += 3) {
    sums[all[i]].source += all[i + 1];
    sums[all[i]].cells += all[i + 2];
  }
}

}  // namespace

template <int D>
void remove_component_means(const Grid<D>& grid, Problem<D>& problem) {
  const Level<D>& level = problem.level;
  const auto label = label_components(grid, level);
  std::map<double, Sum> sums;
  for_live_cells(level, [&](long p, int, int, int) {
    auto& s = sums[label[p]];
    s.source += problem.b[p];
    s.cells += 1;
  });
  merge(grid.parallel(), sums);
  for_live_cells(level, [&](long p, int, int, int) {
    const auto& s = sums[label[p]];
    problem.b[p] -= s.source / s.cells;
  });
}

template void remove_component_means<2>(const Grid<2>&, Problem<2>&);
template void remove_component_means<3>(const Grid<3>&, Problem<3>&);

}  // namespace washtub
