#include "grid/halo.hpp"

#include <algorithm>
#include <cstring>

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
  for (int axis = 1; axis < D; ++axis)
    MPI_Cart_shift(comm, axis - 1, 1, &neighbour_[axis][0], &neighbour_[axis][1]);
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

/// Calls visit(array, start of a run) for the runs of a layer of all arrays, in the order of the
/// message.
template <int D>
template <class T, class Visit>
void Halo<D>::for_runs(std::span<T* const> arrays, int axis, int c, Visit&& visit) const {
  const auto s = slab(block_, axis);
  for (T* a : arrays)
    for (int r = 0; r < s.runs; ++r)
      visit(a + layer(block_, axis, c) + static_cast<long>(r) * s.stride, s.length);
}

/// One message each way to either neighbour, with the layers of all arrays.
template <int D>
template <class T>
void Halo<D>::exchange_axis(std::span<T* const> arrays, int axis) const {
  const auto s = slab(block_, axis);
  const std::size_t bytes = arrays.size() * sizeof(T) * static_cast<std::size_t>(s.runs * s.length);
  const int last = block_.count[axis] - 1;
  std::array<MPI_Request, 4> requests;
  for (int side = 0; side < 2; ++side) {
    outbox_[side].resize(std::max(outbox_[side].size(), bytes));
    inbox_[side].resize(outbox_[side].size());
    MPI_Irecv(inbox_[side].data(), static_cast<int>(bytes), MPI_BYTE, neighbour_[axis][side],
              1 - side, comm_, &requests[side]);
  }
  for (int side = 0; side < 2; ++side) {
    std::byte* to = outbox_[side].data();
    if (neighbour_[axis][side] != MPI_PROC_NULL)
      for_runs(arrays, axis, side == 0 ? 0 : last, [&](const T* from, int n) {
        std::memcpy(to, from, sizeof(T) * n);
        to += sizeof(T) * n;
      });
    MPI_Isend(outbox_[side].data(), static_cast<int>(bytes), MPI_BYTE, neighbour_[axis][side], side,
              comm_, &requests[2 + side]);
  }
  MPI_Waitall(4, requests.data(), MPI_STATUSES_IGNORE);
  for (int side = 0; side < 2; ++side) {
    if (neighbour_[axis][side] == MPI_PROC_NULL) continue;
    const std::byte* from = inbox_[side].data();
    for_runs(arrays, axis, side == 0 ? -1 : last + 1, [&](T* to, int n) {
      std::memcpy(to, from, sizeof(T) * n);
      from += sizeof(T) * n;
    });
  }
}

template <int D>
template <class T>
void Halo<D>::run(std::span<T* const> arrays) const {
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
      exchange_axis(arrays, axis);
  }
}

template <int D>
void Halo<D>::exchange(std::span<double* const> arrays) const {
  run(arrays);
}

template <int D>
void Halo<D>::exchange(std::span<float* const> arrays) const {
  run(arrays);
}

template <int D>
void Halo<D>::exchange(std::span<std::uint8_t* const> arrays) const {
  run(arrays);
}

template class Halo<2>;
template class Halo<3>;

}  // namespace washtub
