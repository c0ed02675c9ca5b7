#include "grid/halo.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace washtub {
namespace {

/// Layers of constant coordinate along `axis`: how many runs, how long, how far apart [values].
template <int D>
struct Slab {
  int runs;
  int length;
  int stride;
};

template <int D>
Slab<D> slab(const Block<D>& b, int axis) {
  if (D == 3 && axis == 1)
    return {b.count[2] + 2, static_cast<int>(b.stride[1]), static_cast<int>(b.stride[2])};
  return {1, static_cast<int>(b.stride[D - 1]), 0};
}

/// Memory position where the layer `c` of `axis` starts: in the middle of the padding between two
/// rows, so that the ghosts at both ends of every row belong to the layer.
template <int D>
long layer(const Block<D>& b, int axis, int c) {
  return Block<D>::pad / 2 + b.stride[axis] * (c + 1);
}

}  // namespace

template <int D>
Halo<D>::Halo(MPI_Comm comm, const Block<D>& block, bool periodic_x)
    : comm_(comm), block_(block), width_(block.width()), periodic_x_(periodic_x) {
  MPI_Comm_rank(comm, &rank_);
  for (int axis = 1; axis < D; ++axis) {
    MPI_Cart_shift(comm, axis - 1, 1, &neighbour_[axis][0], &neighbour_[axis][1]);
    const auto s = slab(block_, axis);
    const std::array<MPI_Datatype, 3> values{MPI_FLOAT, MPI_DOUBLE, MPI_UINT8_T};
    for (std::size_t type = 0; type < values.size(); ++type) {
      MPI_Type_vector(s.runs, s.length, s.stride, values[type], &slab_[type][axis]);
      MPI_Type_commit(&slab_[type][axis]);
    }
  }
}

template <int D>
Halo<D>::~Halo() {
  if (comm_ == MPI_COMM_NULL) return;
  for (auto& types : slab_)
    for (int axis = 1; axis < D; ++axis) MPI_Type_free(&types[axis]);
}

template <int D>
Halo<D>::Halo(Halo&& other) noexcept {
  *this = std::move(other);
}

template <int D>
Halo<D>& Halo<D>::operator=(Halo&& other) noexcept {
  std::swap(comm_, other.comm_);
  std::swap(block_, other.block_);
  std::swap(width_, other.width_);
  std::swap(rank_, other.rank_);
  std::swap(periodic_x_, other.periodic_x_);
  std::swap(neighbour_, other.neighbour_);
  std::swap(slab_, other.slab_);
  return *this;
}

template <int D>
template <class T>
void Halo<D>::copy_axis(T* array, int axis) const {
  const auto s = slab(block_, axis);
  const int n = block_.count[axis];
  for (int r = 0; r < s.runs; ++r) {
    T* base = array + static_cast<long>(r) * s.stride;
    std::copy_n(base + layer(block_, axis, n - 1), s.length, base + layer(block_, axis, -1));
    std::copy_n(base + layer(block_, axis, 0), s.length, base + layer(block_, axis, n));
  }
}

template <int D>
template <class T>
void Halo<D>::exchange_axis(std::span<T* const> arrays, int axis, int type) const {
  const auto [below, above] = neighbour_[axis];
  const int n = block_.count[axis];
  const MPI_Datatype slab_type = slab_[type][axis];
  constexpr std::size_t most = 4;  // arrays at a time
  std::array<MPI_Request, 4 * most> requests;
  for (; arrays.size() > most; arrays = arrays.subspan(most))
    exchange_axis(arrays.first(most), axis, type);
  int count = 0;
  for (T* a : arrays) {
    const int tag = 4 * axis;
    MPI_Irecv(a + layer(block_, axis, -1), 1, slab_type, below, tag, comm_, &requests[count++]);
    MPI_Irecv(a + layer(block_, axis, n), 1, slab_type, above, tag + 1, comm_, &requests[count++]);
    MPI_Isend(a + layer(block_, axis, n - 1), 1, slab_type, above, tag, comm_, &requests[count++]);
    MPI_Isend(a + layer(block_, axis, 0), 1, slab_type, below, tag + 1, comm_, &requests[count++]);
  }
  MPI_Waitall(count, requests.data(), MPI_STATUSES_IGNORE);
}

template <int D>
template <class T>
void Halo<D>::run(std::span<T* const> arrays, int type) const {
  if (periodic_x_) {  // ghost rows too: those beyond a side of the box belong to nobody else
    const int out = D == 3 ? 1 : 0;
    for (T* a : arrays)
      for (int k = -1; k <= block_.planes(); ++k)
        for (int j = -out; j < block_.rows() + out; ++j) wrap_row(a + block_.row(j, k));
  }
  for (int axis = 1; axis < D; ++axis) {
    const auto [below, above] = neighbour_[axis];
    if (below == MPI_PROC_NULL && above == MPI_PROC_NULL) continue;
    if (below == rank_)
      for (T* a : arrays) copy_axis(a, axis);
    else
      exchange_axis(arrays, axis, type);
  }
}

template <int D>
void Halo<D>::exchange(std::span<double* const> arrays) const {
  run(arrays, 1);
}

template <int D>
void Halo<D>::exchange(std::span<float* const> arrays) const {
  run(arrays, 0);
}

template <int D>
void Halo<D>::exchange(std::span<std::uint8_t* const> arrays) const {
  run(arrays, 2);
}

template class Halo<2>;
template class Halo<3>;

}  // namespace washtub
