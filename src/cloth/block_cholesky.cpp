#include "cloth/block_cholesky.hpp"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCore>
#include <cmath>
#include <set>

namespace washtub {
namespace {

/// C -= A B^T, lane by lane.
template <int D>
inline void subtract_product(const double* __restrict A, const double* __restrict B,
                             double* __restrict C) {
#pragma omp simd
  for (int l = 0; l < lanes; ++l) {
#pragma GCC unroll 3
    for (int r = 0; r < D; ++r) {
#pragma GCC unroll 3
      for (int c = 0; c < D; ++c) {
        double sum = C[(r * D + c) * lanes + l];
#pragma GCC unroll 3
        for (int m = 0; m < D; ++m) sum -= A[(r * D + m) * lanes + l] * B[(c * D + m) * lanes + l];
        C[(r * D + c) * lanes + l] = sum;
      }
    }
  }
}

/// A = A K^T, K lower triangular.
template <int D>
inline void scale(const double* __restrict K, double* __restrict A) {
#pragma omp simd
  for (int l = 0; l < lanes; ++l) {
#pragma GCC unroll 3
    for (int r = 0; r < D; ++r) {
#pragma GCC unroll 3
      for (int c = D - 1; c >= 0; --c) {
        double sum = 0;
#pragma GCC unroll 3
        for (int m = 0; m <= c; ++m) sum += A[(r * D + m) * lanes + l] * K[(c * D + m) * lanes + l];
        A[(r * D + c) * lanes + l] = sum;
      }
    }
  }
}

/// A = inverse of the Cholesky factor of A, zero above the diagonal.
template <int D>
inline void invert_factor(double* A) {
#pragma omp simd
  for (int l = 0; l < lanes; ++l) {
    double L[D][D] = {}, K[D][D] = {};
    for (int c = 0; c < D; ++c) {
      for (int r = c; r < D; ++r) {
        double sum = A[(r * D + c) * lanes + l];
        for (int m = 0; m < c; ++m) sum -= L[r][m] * L[c][m];
        L[r][c] = r == c ? std::sqrt(sum) : sum * K[c][c];
        if (r == c) K[c][c] = 1 / L[c][c];
      }
    }
    for (int c = 0; c < D; ++c) {
      for (int r = c + 1; r < D; ++r) {
        double sum = 0;
        for (int m = c; m < r; ++m) sum -= L[r][m] * K[m][c];
        K[r][c] = sum * K[r][r];
      }
    }
    for (int r = 0; r < D; ++r)
      for (int c = 0; c < D; ++c) A[(r * D + c) * lanes + l] = K[r][c];
  }
}

/// y = sign A x + keep y, or with A^T.
template <int D, bool transposed>
inline void multiply(const double* A, const double* x, double sign, double keep, double* y) {
#pragma omp simd
  for (int l = 0; l < lanes; ++l) {
    double out[D];
    for (int r = 0; r < D; ++r) {
      out[r] = keep * y[r * lanes + l];
      for (int c = 0; c < D; ++c)
        out[r] += sign * A[(transposed ? c * D + r : r * D + c) * lanes + l] * x[c * lanes + l];
    }
    for (int r = 0; r < D; ++r) y[r * lanes + l] = out[r];
  }
}

}  // namespace

template <int D>
BlockCholesky<D>::BlockCholesky(int nodes, const std::vector<std::pair<int, int>>& coupled,
                                const std::vector<int>& absent)
    : position_(nodes, 0) {
  for (const int x : absent) position_[x] = -1;
  order(coupled);
  find_pattern(coupled);
  list_products();
  values_.assign(row_.size() * size, 0.0);
}

template <int D>
void BlockCholesky<D>::order(const std::vector<std::pair<int, int>>& coupled) {
  std::vector<int> compact(position_.size(), -1);
  for (std::size_t x = 0; x < position_.size(); ++x)
    if (position_[x] >= 0) compact[x] = rows_++;
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [x, y] : coupled) {
    if (compact[x] < 0 || compact[y] < 0) continue;
    entries.emplace_back(compact[x], compact[y], 1.0);
    entries.emplace_back(compact[y], compact[x], 1.0);
  }
  Eigen::SparseMatrix<double> graph(rows_, rows_);
  graph.setFromTriplets(entries.begin(), entries.end());
  Eigen::AMDOrdering<int>::PermutationType sequence;
  Eigen::AMDOrdering<int>()(graph, sequence);  // sequence[n]: the node to eliminate as the n-th
  std::vector<int> place(rows_);
  for (int n = 0; n < rows_; ++n) place[sequence.indices()[n]] = n;
  for (std::size_t x = 0; x < position_.size(); ++x)
    if (compact[x] >= 0) position_[x] = place[compact[x]];
}

template <int D>
void BlockCholesky<D>::find_pattern(const std::vector<std::pair<int, int>>& coupled) {
  std::vector<std::set<int>> below(rows_);  // rows under the diagonal of each column of L
  for (const auto& [x, y] : coupled) {
    const int p = position_[x], q = position_[y];
    if (p >= 0 && q >= 0 && p != q) below[std::min(p, q)].insert(std::max(p, q));
  }
  for (int k = 0; k < rows_; ++k) {
    column_.push_back(static_cast<int>(row_.size()));
    row_.push_back(k);
    row_.insert(row_.end(), below[k].begin(), below[k].end());
    if (below[k].empty()) continue;
    const int parent = *below[k].begin();
    below[parent].insert(std::next(below[k].begin()), below[k].end());
  }
  column_.push_back(static_cast<int>(row_.size()));
}

template <int D>
void BlockCholesky<D>::list_products() {
  std::vector<std::vector<std::pair<int, int>>> in_row(rows_);  // (block, end of its column)
  for (int k = 0; k < rows_; ++k)
    for (int n = column_[k] + 1; n < column_[k + 1]; ++n)
      in_row[row_[n]].emplace_back(n, column_[k + 1]);
  for (int j = 0; j < rows_; ++j) {
    first_panel_.push_back(static_cast<int>(panels_.size()));
    for (const auto& [first, last] : in_row[j]) {
      panels_.push_back({first, last, static_cast<int>(target_.size())});
      for (int n = first; n < last; ++n) target_.push_back(find(row_[n], j));
    }
  }
  first_panel_.push_back(static_cast<int>(panels_.size()));
}

template <int D>
int BlockCholesky<D>::find(int row, int column) const {
  const auto first = row_.begin() + column_[column], last = row_.begin() + column_[column + 1];
  return static_cast<int>(std::lower_bound(first, last, row) - row_.begin());
}

template <int D>
Place BlockCholesky<D>::place(int x, int y) const {
  const int p = position_[x], q = position_[y];
  if (p < 0 || q < 0) return {};
  return {find(std::max(p, q), std::min(p, q)), p < q};
}

template <int D>
void BlockCholesky<D>::factorise() {
  for (int j = 0; j < rows_; ++j) {
    for (int p = first_panel_[j]; p < first_panel_[j + 1]; ++p) {
      const Panel& panel = panels_[p];
      const int* target = target_.data() + panel.first_target;
      const double* B = block(panel.first);
      for (int n = panel.first; n < panel.last; ++n)
        subtract_product<D>(block(n), B, block(*target++));
    }
    double* K = block(column_[j]);
    invert_factor<D>(K);
    for (int n = column_[j] + 1; n < column_[j + 1]; ++n) scale<D>(K, block(n));
  }
}

template <int D>
void BlockCholesky<D>::solve(double* x) const {
  constexpr int stride = D * lanes;
  const double one = 1, zero = 0;
  for (int j = 0; j < rows_; ++j) {
    double* xj = x + j * stride;
    multiply<D, false>(block(column_[j]), xj, one, zero, xj);
    for (int n = column_[j] + 1; n < column_[j + 1]; ++n)
      multiply<D, false>(block(n), xj, -one, one, x + row_[n] * stride);
  }
  for (int j = rows_ - 1; j >= 0; --j) {
    double* xj = x + j * stride;
    for (int n = column_[j] + 1; n < column_[j + 1]; ++n)
      multiply<D, true>(block(n), x + row_[n] * stride, -one, one, xj);
    multiply<D, true>(block(column_[j]), xj, one, zero, xj);
  }
}

template class BlockCholesky<2>;
template class BlockCholesky<3>;

}  // namespace washtub
