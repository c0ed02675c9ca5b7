#include "report/fields.hpp"

#include <algorithm>

#include "record/names.hpp"

namespace washtub {
namespace {

std::size_t product(const std::array<int, 3>& n) {
  return static_cast<std::size_t>(n[0]) * static_cast<std::size_t>(n[1]) *
         static_cast<std::size_t>(n[2]);
}

/// Derivative of a row of n values, `stride` apart, at place i.
double slope(const float* row, int i, int n, long stride, double h, bool periodic) {
  if (n < 2) return 0;
  int low = i - 1, high = i + 1;
  const int steps = periodic ? 2 : std::min(high, n - 1) - std::max(low, 0);
  low = periodic ? (low + n) % n : std::max(low, 0);
  high = periodic ? high % n : std::min(high, n - 1);
  return (row[high * stride] - row[low * stride]) / (steps * h);
}

/// The fine cells of each coarse one.
struct Coarsening {
  std::array<int, 3> fine, coarse;

  /// Calls visit(coarse cell, fine cell) for every fine cell.
  template <class Visit>
  void each(const Visit& visit) const {
    std::size_t n = 0;
    for (int k = 0; k < fine[2]; ++k)
      for (int j = 0; j < fine[1]; ++j)
        for (int i = 0; i < fine[0]; ++i, ++n)
          visit(static_cast<std::size_t>(i / 2 + coarse[0] * (j / 2 + coarse[1] * (k / 2))), n);
  }
};

/// Means of the fine values with the weights of their cells.
void average(const Coarsening& map, const std::vector<float>& weight,
             const std::vector<float>& total, const float* fine, float* coarse) {
  map.each([&](std::size_t c, std::size_t f) { coarse[c] += fine[f] * weight[f]; });
  for (std::size_t c = 0; c < total.size(); ++c) coarse[c] /= total[c];
}

}  // namespace

std::vector<float> vorticity(const std::vector<float>& velocity, std::array<int, 3> cells,
                             const Vec<3>& spacing, std::array<bool, 2> periodic) {
  const long nx = cells[0], ny = cells[1];
  std::vector<float> out(static_cast<std::size_t>(nx * ny));
  const float *u = velocity.data(), *v = u + nx * ny;
  for (int j = 0; j < ny; ++j)
    for (int i = 0; i < nx; ++i) {
      const double dv = slope(v + j * nx, i, cells[0], 1, spacing[0], periodic[0]);
      const double du = slope(u + i, j, cells[1], nx, spacing[1], periodic[1]);
      out[static_cast<std::size_t>(i + j * nx)] = static_cast<float>(dv - du);
    }
  return out;
}

Lattice lattice(const WaterFrame& water, int dimension, const Vec<3>& spacing,
                std::array<bool, 2> periodic) {
  const auto *velocity = find(water.fields, names::velocity),
             *solid = find(water.fields, names::solid);
  if (!velocity || !solid) return {};
  Lattice out{water.cells, dimension, {}, {}, *solid, {}};
  const std::size_t n = out.size();
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimension); ++d)
    for (std::size_t c = 0; c < n; ++c) out.velocity.push_back((*velocity)[3 * c + d]);
  for (const auto& one : water.fields)
    if (one.field.components == 1 && one.field.name != names::solid) out.scalars.push_back(one);
  if (dimension == 2) out.vorticity = vorticity(out.velocity, out.cells, spacing, periodic);
  return out;
}

std::array<int, 3> coarse_cells(std::array<int, 3> cells, int times) {
  for (int& n : cells)
    for (int t = 0; t < times; ++t) n = (n + 1) / 2;
  return cells;
}

Lattice coarsen(const Lattice& fine) {
  const Coarsening map{fine.cells, coarse_cells(fine.cells, 1)};
  Lattice out{map.coarse, fine.axes, {}, {}, {}, {}};
  const std::size_t n = product(out.cells);
  std::vector<float> open(fine.size()), total(n, 0), count(n, 0);
  // Cells all in solids count a little, so that a coarse cell of nothing else has a mean as well.
  for (std::size_t f = 0; f < fine.size(); ++f) open[f] = std::max(1 - fine.solid[f], 1e-6F);
  map.each([&](std::size_t c, std::size_t f) { total[c] += open[f], count[c] += 1; });
  const std::vector<float> equal(fine.size(), 1);
  out.velocity.assign(static_cast<std::size_t>(fine.axes) * n, 0);
  for (std::size_t d = 0; d < static_cast<std::size_t>(fine.axes); ++d)
    average(map, open, total, &fine.velocity[d * fine.size()], &out.velocity[d * n]);
  out.solid.assign(n, 0);
  average(map, equal, count, fine.solid.data(), out.solid.data());
  for (const auto& [field, values] : fine.scalars) {
    out.scalars.push_back({field, std::vector<float>(n, 0)});
    average(map, open, total, values.data(), out.scalars.back().values.data());
  }
  out.vorticity.assign(fine.vorticity.empty() ? 0 : n, 0);
  if (!out.vorticity.empty())
    average(map, open, total, fine.vorticity.data(), out.vorticity.data());
  return out;
}

}  // namespace washtub
