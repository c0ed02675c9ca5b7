#include "flow/pressure/gather.hpp"

#include <algorithm>

namespace washtub {

template <int D>
GatherBlocks<D>::GatherBlocks(const Parallel& parallel, const Block<D>& part)
    : parallel_(parallel) {
  const auto ranks = static_cast<std::size_t>(parallel.size());
  std::array<int, 2 * D> mine;
  std::copy(part.offset.begin(), part.offset.end(), mine.begin());
  std::copy(part.count.begin(), part.count.end(), mine.begin() + D);
  boxes_.resize(ranks * 2 * D);
  MPI_Allgather(mine.data(), 2 * D, MPI_INT, boxes_.data(), 2 * D, MPI_INT, parallel.comm());
  int total = 0;
  for (std::size_t r = 0; r < ranks; ++r) {
    int n = 1;
    for (int d = 0; d < D; ++d) n *= boxes_[r * 2 * D + static_cast<std::size_t>(D + d)];
    sizes_.push_back(n);
    starts_.push_back(total);
    total += n;
  }
  packed_.resize(static_cast<std::size_t>(total));
}

/// Calls copy(position in memory, position in the packed array, width) for every row of a rank.
template <int D>
template <class Copy>
void GatherBlocks<D>::for_rows(int rank, const Block<D>& whole, Copy&& copy) const {
  const int* box = boxes_.data() + static_cast<long>(rank) * 2 * D;
  const int rows = D == 3 ? box[D + 1] : 1, first = D == 3 ? box[1] : 0;
  long packed = starts_[static_cast<std::size_t>(rank)];
  for (int k = 0; k < box[2 * D - 1]; ++k)
    for (int j = 0; j < rows; ++j) {
      copy(whole.row(first + j, box[D - 1] + k), packed, box[D]);
      packed += box[D];
    }
}

template <int D>
void GatherBlocks<D>::all(float* array, const Block<D>& whole) {
  for_rows(parallel_.rank(), whole,
           [&](long from, long to, int n) { std::copy_n(array + from, n, packed_.data() + to); });
  MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, packed_.data(), sizes_.data(), starts_.data(),
                 MPI_FLOAT, parallel_.comm());
  for (int r = 0; r < parallel_.size(); ++r)
    for_rows(r, whole,
             [&](long to, long from, int n) { std::copy_n(packed_.data() + from, n, array + to); });
}

template class GatherBlocks<2>;
template class GatherBlocks<3>;

}  // namespace washtub
