#include "flow/dissipation.hpp"

#include <cmath>

namespace washtub {
namespace {

template <int D>
class Rate {
 public:
  explicit Rate(const Flow<D>& flow)
      : flow_(flow), grid_(flow.grid()), block_(grid_.block()), open_(flow.openings().open) {}

  /// Integral of 2 S:S [m^D/s^2].
  double of_all() const {
    double sum = 0;
    for (int c = 0; c < D; ++c) {
      sum += of_cells(c);
      for (int d = c + 1; d < D; ++d) sum += of_edges(c, d);
      for (const auto& face : *flow_.openings().held[c])
        sum += face.drag * std::pow(flow_.velocity()[c][face.p] - face.wall, 2);
    }
    return grid_.mesh().cell_volume() * sum;
  }

 private:
  /// 2 (du_c/dx_c)^2 of the cells that have an open face along c.
  double of_cells(int c) const {
    const long s = block_.stride[c];
    const double per_h = 1 / grid_.mesh().h[c];
    double sum = 0;
    for (int k = 0; k < block_.planes(); ++k)
      for (int j = 0; j < block_.rows(); ++j) {
        const double* u = flow_.velocity()[c].data() + block_.row(j, k);
        const float* open = open_[c] + block_.row(j, k);
#pragma omp simd reduction(+ : sum)
        for (int i = 0; i < block_.width(); ++i) {
          const double slope = per_h * (u[i + s] - u[i]);
          sum += open[i] + open[i + s] > 0 ? 2 * slope * slope : 0.0;
        }
      }
    return sum;
  }

  /// Weight of edges at position i along an axis: half of the volume around those on a side is
  /// outside the box.
  double weight(int axis, int i) const {
    const bool lower = i == 0 && grid_.at_side(axis, 0);
    const bool upper = i == block_.count[axis] && grid_.at_side(axis, 1);
    return lower || upper ? 0.5 : 1;
  }

  /// (du_c/dx_d + du_d/dx_c)^2 of the edges along the third axis, those on upper sides included.
  double of_edges(int c, int d) const {
    Index<D> end = block_.count;
    for (const int axis : {c, d}) end[axis] += grid_.at_side(axis, 1);
    double sum = 0;
    for (int k = 0; k < end[D - 1]; ++k)
      for (int j = 0; j < (D == 3 ? end[1] : 1); ++j) {
        const double around =
            (d == D - 1 ? weight(d, k) : 1) * (D == 3 && (c == 1 || d == 1) ? weight(1, j) : 1);
        const long p = block_.row(j, k);
        if (c > 0) {
          sum += around * of_row(c, d, p, end[0]);
          continue;
        }
        const int inner = block_.width() - 1;
        sum += around * (weight(0, 0) * of_row(c, d, p, 1) + of_row(c, d, p + 1, inner));
        if (end[0] > block_.width())
          sum += around * weight(0, end[0] - 1) * of_row(c, d, p + end[0] - 1, 1);
      }
    return sum;
  }

  /// Of n edges along x at the lower corners of the cells from p on.
  double of_row(int c, int d, long p, int n) const {
    const double *u = flow_.velocity()[c].data() + p, *w = flow_.velocity()[d].data() + p;
    const float *open_u = open_[c] + p, *open_w = open_[d] + p;
    const long s = block_.stride[d], t = block_.stride[c];
    const double per_s = 1 / grid_.mesh().h[d], per_t = 1 / grid_.mesh().h[c];
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int i = 0; i < n; ++i) {
      const double a = per_s * (u[i] - u[i - s]), b = per_t * (w[i] - w[i - t]);
      const double from_a = open_u[i] + open_u[i - s] > 0 ? a : 0;
      const double from_b = open_w[i] + open_w[i - t] > 0 ? b : 0;
      sum += (a + b) * (from_a + from_b);
    }
    return sum;
  }

  const Flow<D>& flow_;
  const Grid<D>& grid_;
  const Block<D>& block_;
  std::array<const float*, D> open_;
};

/// Sum of u at the open faces of component c next to a side, and their number.
template <int D>
std::array<double, 2> beside(const Flow<D>& flow, int c, int axis, int side) {
  const auto& block = flow.grid().block();
  Index<D> first{}, last = block.count, at{};
  if (side == 1) first[axis] = block.count[axis] - 1;
  last[axis] = first[axis] + 1;
  std::array<double, 2> sum{};
  for (int k = first[D - 1]; k < last[D - 1]; ++k)
    for (int j = D == 3 ? first[1] : 0; j < (D == 3 ? last[1] : 1); ++j)
      for (int i = first[0]; i < last[0]; ++i) {
        at[0] = i;
        if constexpr (D == 3) at[1] = j;
        at[D - 1] = k;
        const long p = block.at(at);
        const double on = flow.openings().open[c][p];
        sum[0] += on * flow.velocity()[c][p];
        sum[1] += on;
      }
  return sum;
}

}  // namespace

template <int D>
double dissipation(const Flow<D>& flow) {
  return flow.viscosity() * flow.grid().parallel().sum(Rate<D>(flow).of_all());
}

template <int D>
double power_of_sides(const Flow<D>& flow, const SidePairs<D>& sides) {
  const auto& grid = flow.grid();
  double power = 0;
  for (int axis = 0; axis < D; ++axis)
    for (int side = 0; side < 2; ++side) {
      const auto& wall = sides[axis][side];
      if (!grid.at_side(axis, side) || wall.kind != Side<D>::Kind::wall) continue;
      const double h = grid.mesh().h[axis], area = grid.mesh().cell_volume() / h;
      for (int c = 0; c < D; ++c) {
        const double U = wall.velocity[c];
        if (c == axis || U == 0) continue;
        const auto [u, faces] = beside(flow, c, axis, side);
        power += flow.viscosity() * area * U * (U * faces - u) / (0.5 * h);
      }
    }
  return grid.parallel().sum(power);
}

template double dissipation<2>(const Flow<2>&);
template double dissipation<3>(const Flow<3>&);
template double power_of_sides<2>(const Flow<2>&, const SidePairs<2>&);
template double power_of_sides<3>(const Flow<3>&, const SidePairs<3>&);

}  // namespace washtub
