#pragma once
#include <Eigen/Core>
#include <utility>
#include <vector>

#include "cloth/assembly.hpp"

namespace washtub {

/// Pieces solved side by side: the width of a vector register of doubles.
inline constexpr int lanes = 8;

/// Numbers of several pieces side by side, aligned for vector registers.
template <class T>
using LaneVector = std::vector<T, Eigen::aligned_allocator<T>>;

/// Cholesky factorisation A = L L^T of `lanes` symmetric positive definite matrices of one pattern
/// at once. A matrix has a D x D block for each coupled pair of nodes. The fill-reducing order
/// (approximate minimum degree), the pattern of L and the list of block products are found once;
/// factorising and solving allocate nothing.
template <int D>
class BlockCholesky {
 public:
  /// @param nodes    number of block rows
  /// @param coupled  pairs (x, y), x >= y, including (x, x), of nodes that share a block
  /// @param absent   nodes without rows (pinned)
  BlockCholesky(int nodes, const std::vector<std::pair<int, int>>& coupled,
                const std::vector<int>& absent);

  int blocks() const { return static_cast<int>(row_.size()); }  ///< in L
  std::size_t products() const { return target_.size(); }       ///< of blocks, in `factorise`
  int position(int node) const { return position_[node]; }      ///< in the order, -1 if absent

  /// Where block (x, y) of A goes in `data()`; index -1 if x or y is absent.
  Place place(int x, int y) const;
  /// Blocks [index][row][column][lane]: A before `factorise`, L after it.
  double* data() { return values_.data(); }

  /// On return the blocks hold L, with its diagonal blocks inverted. A lane that is not positive
  /// definite becomes NaN.
  void factorise();
  /// On return x = A^-1 x, where x is [position][component][lane].
  void solve(double* x) const;

 private:
  /// Products of one block (j, k) of L with the blocks of column k from there on.
  struct Panel {
    int first, last;   ///< blocks of column k
    int first_target;  ///< in target_
  };
  static constexpr int size = D * D * lanes;

  void order(const std::vector<std::pair<int, int>>& coupled);
  void find_pattern(const std::vector<std::pair<int, int>>& coupled);
  void list_products();
  int find(int row, int column) const;
  double* block(int n) { return values_.data() + static_cast<std::ptrdiff_t>(n) * size; }
  const double* block(int n) const {
    return values_.data() + static_cast<std::ptrdiff_t>(n) * size;
  }

  std::vector<int> position_;     ///< of each node
  int rows_ = 0;                  ///< nodes that are not absent
  std::vector<int> column_;       ///< first block of each column, the diagonal one
  std::vector<int> row_;          ///< of each block
  std::vector<int> first_panel_;  ///< of each column
  std::vector<Panel> panels_;
  std::vector<int> target_;  ///< block that each product is subtracted from
  LaneVector<double> values_;
};

}  // namespace washtub
