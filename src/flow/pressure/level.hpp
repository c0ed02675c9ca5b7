#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "grid/grid.hpp"

namespace washtub {

/// One level of the masked Poisson problem  sum_faces g phi (x - x_neighbour) = b : the unknowns,
/// the open fraction phi of each face (0 closed, 1 open) and where in each row cells are live. In
/// single precision, for corrections.
template <int D>
struct Level {
  Block<D> block;
  Halo<D> halo;
  Index<D> factor{};  ///< cells of the finer level per cell of this one
  Index<D> place{};   ///< where this rank's part starts (gathered levels), else 0
  Index<D> clash{};   ///< cells of the whole axis where its first and last are neighbours of one
                      ///< colour (periodic, odd), else 0
  std::array<float, D> g;  ///< 1/(rho h^2) along each axis
  Storage<float> x, b;
  std::array<const float*, D> open;          ///< open fraction of the lower faces of each axis
  Storage<float> inverse_diagonal;           ///< 0 in dead cells
  std::vector<int> begin, end;               ///< range of each row, outside of it no cell is live
  std::array<std::vector<float>, 2> colour;  ///< 1 on the cells of a colour, else 0
  mutable std::vector<float> row_buffer;

  /// @param cells     of the whole level
  /// @param periodic  axes along which the box repeats
  void allocate(const Block<D>& block_, const Index<D>& cells,
                const std::array<bool, D>& periodic) {
    block = block_;
    for (int d = 0; d < D; ++d) clash[d] = periodic[d] && cells[d] % 2 == 1 ? cells[d] : 0;
    const auto n = static_cast<std::size_t>(block.size);
    x = Storage<float>(n);
    b = Storage<float>(n);
    inverse_diagonal = Storage<float>(n);
    begin.assign(static_cast<std::size_t>(block.rows() * block.planes()), 0);
    end = begin;
    for (int c = 0; c < 2; ++c) {
      colour[c].resize(static_cast<std::size_t>(block.width()) + 16);
      for (std::size_t i = 0; i < colour[c].size(); ++i)
        colour[c][i] = static_cast<int>(i & 1) == c ? 1.0F : 0.0F;
    }
    row_buffer.resize(static_cast<std::size_t>(block.width()) + 16);
  }
};

/// The problem to be solved, on the cells of the finest level and in double precision.
template <int D>
struct Problem {
  const Level<D>& level;
  std::array<double, D> g;  ///< 1/(rho h^2) along each axis
  Storage<double> x, b;
};

/// One row of a level or of the problem, ready for the inner loops.
template <int D, class T>
struct LevelRow {
  long p;
  int begin, end;
  const T *x, *b;
  std::array<const float*, D> open;
  std::array<long, D> s;
  std::array<T, D> g;

  /// @param of  has the values
  template <class Of>
  LevelRow(const Level<D>& l, const Of& of, int j, int k) : s(l.block.stride), g(of.g) {
    const auto r = static_cast<std::size_t>(l.block.row_index(j, k));
    begin = l.begin[r];
    end = l.end[r];
    p = l.block.row(j, k);
    x = of.x.data() + p;
    b = of.b.data() + p;
    for (int d = 0; d < D; ++d) open[d] = l.open[d] + p;
  }
  template <int d>
  T flux(int i, T o) const {
    const long t = d == 0 ? 1 : s[d];
    return g[d] * (static_cast<T>(open[d][i]) * (x[i - t] - o) +
                   static_cast<T>(open[d][i + t]) * (x[i + t] - o));
  }
  /// b - A x in cell i.
  T residual(int i) const {
    const T o = x[i];
    T r = b[i] + flux<0>(i, o) + flux<1>(i, o);
    if constexpr (D == 3) r += flux<2>(i, o);
    return r;
  }
};

template <int D>
LevelRow<D, float> row_of(const Level<D>& l, int j, int k) {
  return {l, l, j, k};
}
template <int D>
LevelRow<D, double> row_of(const Problem<D>& p, int j, int k) {
  return {p.level, p, j, k};
}

/// Over-relaxed Gauss-Seidel on the cells of one colour of a row. In difference form: single
/// precision coefficients would otherwise bound the accuracy. The update goes through a buffer
/// because an in-place one does not vectorise.
template <int D>
void relax_row(Level<D>& l, int j, int k, int colour, float omega) {
  const auto row = row_of(l, j, k);
  float* __restrict__ fresh = l.row_buffer.data();
  float* x = l.x.data() + row.p;
  const float* id = l.inverse_diagonal.data() + row.p;
  const float* on = l.colour[(l.block.parity(j, k) + colour) & 1].data();
#pragma omp simd
  for (int i = row.begin; i < row.end; ++i)
    fresh[i] = row.x[i] + omega * on[i] * id[i] * row.residual(i);
#pragma omp simd
  for (int i = row.begin; i < row.end; ++i) x[i] = fresh[i];
}

/// How large a residual is.
struct ResidualSize {
  double largest = 0, squares = 0;  ///< largest absolute value, sum of squares

  void add(const ResidualSize& other) {
    largest = std::max(largest, other.largest);
    squares += other.squares;
  }
};

/// Adds the residual of a row to `sum`.
template <int D>
void residual_row(const Level<D>& l, int j, int k, float* __restrict__ sum) {
  const auto row = row_of(l, j, k);
#pragma omp simd
  for (int i = row.begin; i < row.end; ++i) sum[i] += row.residual(i);
}

/// The same for the problem; the residual is also the right-hand side b of its correction.
/// Returns its size.
template <int D>
ResidualSize residual_row(const Problem<D>& problem, int j, int k, float* __restrict__ b,
                          float* __restrict__ sum) {
  const auto row = row_of(problem, j, k);
  double largest = 0, squares = 0;
#pragma omp simd reduction(max : largest) reduction(+ : squares)
  for (int i = row.begin; i < row.end; ++i) {
    const double r = row.residual(i);
    b[i] = static_cast<float>(r);
    sum[i] += static_cast<float>(r);
    largest = std::max(largest, std::abs(r));
    squares += r * r;
  }
  return {largest, squares};
}

/// Adds the right-hand side of a row to `sum`.
template <int D>
void source_row(const Level<D>& l, int j, int k, float* __restrict__ sum) {
  const auto row = row_of(l, j, k);
#pragma omp simd
  for (int i = row.begin; i < row.end; ++i) sum[i] += row.b[i];
}

/// Interpolates the coarse correction to a fine row: the parent's value plus a quarter of the
/// difference to the neighbour on the child's side, weighted with the open fraction of the coarse
/// face between them, so that nothing passes through closed faces. Dead cells stay zero.
template <bool add, int D>
void prolong_row(Level<D>& l, const Level<D>& coarse, int j, int k) {
  const auto r = static_cast<std::size_t>(l.block.row_index(j, k));
  const int begin = l.begin[r], end = l.end[r];
  if (begin >= end) return;
  const int row_factor = D == 3 ? coarse.factor[1] : 1, plane_factor = coarse.factor[D - 1];
  const int J = j / row_factor + (D == 3 ? coarse.place[1] : 0);
  const int K = k / plane_factor + coarse.place[D - 1];
  const long q = coarse.block.row(J, K);
  const float* c = coarse.x.data() + q;
  float* __restrict__ o = l.x.data() + l.block.row(j, k);

  const auto side = [&](int d, int child) {  // offset of the neighbour and its face
    const long s = coarse.block.stride[d];
    return std::pair{child & 1 ? s : -s, child & 1 ? s : 0L};
  };
  const long zn = side(D - 1, k).first, zf = side(D - 1, k).second;
  [[maybe_unused]] const long yn = side(D == 3 ? 1 : D - 1, j).first;
  const long yf = side(D == 3 ? 1 : D - 1, j).second;
  const float wz = plane_factor == 2 ? 0.25F : 0.0F, wy = row_factor == 2 ? 0.25F : 0.0F;
  const float* openz = coarse.open[D - 1] + q + zf;
  const float* openy = coarse.open[D == 3 ? 1 : D - 1] + q + yf;
  const float* openx = coarse.open[0] + q;
  const auto across = [&](int i) {
    float v = c[i] + wz * openz[i] * (c[i + zn] - c[i]);
    if constexpr (D == 3) v += wy * openy[i] * (c[i + yn] - c[i]);
    return v;
  };
  const float* live = l.inverse_diagonal.data() + l.block.row(j, k);
  const auto put = [&](int i, float v) {
    const float correction = live[i] > 0 ? v : 0.0F;
    o[i] = add ? o[i] + correction : correction;
  };
  if (coarse.factor[0] == 1) {
#pragma omp simd
    for (int i = begin; i < end; ++i) put(i, across(i));
  } else {
#pragma omp simd
    for (int i = begin / 2; i < (end + 1) / 2; ++i) {
      const float v = across(i);
      put(2 * i, v + 0.25F * openx[i] * (c[i - 1] - c[i]));
      put(2 * i + 1, v + 0.25F * openx[i + 1] * (c[i + 1] - c[i]));
    }
  }
}

/// Weight in the diagonal of a link between neighbours of one colour, which move at once: from
/// omega = 1.15 on, the over-relaxation of the sweeps, these converge for any openings.
inline constexpr float clash_weight = 1.2F;

/// Inverse diagonal and live range of a row from its open fractions. The range begins and ends on
/// vector boundaries, or with the row: what is left of a vector costs as much as several whole
/// ones.
template <int D>
void finish_row(Level<D>& l, int j, int k) {
  const long p = l.block.row(j, k);
  const int n = l.block.width();
  float* __restrict__ id = l.inverse_diagonal.data() + p;
  const Index<D> cell = l.block.row_cell(j, k);
  std::array<float, D> lower, upper;
  for (int d = 0; d < D; ++d) {
    lower[d] = upper[d] = l.g[d];
    if (d == 0 || l.clash[d] == 0) continue;
    if (cell[d] == 0) lower[d] *= clash_weight;
    if (cell[d] == l.clash[d] - 1) upper[d] *= clash_weight;
  }
  const float *ox = l.open[0] + p, *oy = l.open[1] + p, *oz = l.open[D - 1] + p;
  const long sy = l.block.stride[1], sz = l.block.stride[D - 1];
  const auto inverse = [&](int i, float left, float right) {
    float a = left * ox[i] + right * ox[i + 1] + lower[1] * oy[i] + upper[1] * oy[i + sy];
    if constexpr (D == 3) a += lower[2] * oz[i] + upper[2] * oz[i + sz];
    return a > 0 ? 1.0F / a : 0.0F;
  };
#pragma omp simd
  for (int i = 0; i < n; ++i) id[i] = inverse(i, lower[0], upper[0]);
  if (l.clash[0] > 0) {
    id[0] = inverse(0, clash_weight * lower[0], upper[0]);
    id[n - 1] = inverse(n - 1, lower[0], clash_weight * upper[0]);
  }
  int first = 0, last = n;
  while (first < last && id[first] == 0) ++first;
  while (last > first && id[last - 1] == 0) --last;
  const auto r = static_cast<std::size_t>(l.block.row_index(j, k));
  l.begin[r] = first < last ? first / 16 * 16 : 0;
  l.end[r] = first < last ? std::min((last + 15) / 16 * 16, n) : 0;
}

}  // namespace washtub
