#pragma once
#include <array>

#include "base/vec.hpp"

namespace washtub {

/// The cells of one rank and where their values lie in memory. Rows run along x and are contiguous;
/// rows of equal last coordinate form a plane (in 2-D a plane is one row). One ghost layer all
/// round; a row is padded so that it starts on a vector boundary and its ghosts fit in the padding.
template <int D>
struct Block {
  Index<D> offset{};  ///< first cell of the block in the whole grid
  Index<D> count{};   ///< cells of the block along each axis
  std::array<long, D> stride{};
  long size = 0;  ///< values in memory, ghosts and padding included

  Block() = default;
  Block(const Index<D>& offset_, const Index<D>& count_) : offset(offset_), count(count_) {
    stride[0] = 1;
    long n = (count[0] + pad - 1) / pad * pad + pad;
    for (int d = 1; d < D; ++d) {
      stride[d] = n;
      n *= count[d] + 2;
    }
    size = n + 2 * pad;
  }

  int width() const { return count[0]; }
  int rows() const { return D == 3 ? count[1] : 1; }
  int planes() const { return count[D - 1]; }
  int row_index(int j, int k) const { return k * rows() + j; }

  /// Memory position of cell (0, j, k) of the block; in 2-D j is 0 and k runs along y.
  long row(int j, int k) const {
    if constexpr (D == 3)
      return pad + stride[1] * (j + 1) + stride[2] * (k + 1);
    else
      return pad + stride[1] * (k + 1);
  }
  long at(const Index<D>& c) const {
    long p = pad;
    for (int d = 0; d < D; ++d) p += stride[d] * (c[d] + (d > 0));
    return p;
  }
  /// Cell of the whole grid at the start of row (j, k).
  Index<D> row_cell(int j, int k) const {
    Index<D> c = offset;
    if constexpr (D == 3) c[1] += j;
    c[D - 1] += k;
    return c;
  }
  /// Parity of the first cell of row (j, k), equal on every decomposition.
  int parity(int j, int k) const {
    int s = j + k;
    for (int d = 0; d < D; ++d) s += offset[d];
    return s & 1;
  }

  static constexpr long pad = 16;
};

}  // namespace washtub
