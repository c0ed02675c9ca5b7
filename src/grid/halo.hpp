#pragma once
#include <mpi.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/block.hpp"
#include "grid/storage.hpp"

namespace washtub {

/// Fills the ghost layers that belong to other ranks or, on periodic axes, to the far side.
/// Ghosts beyond a side of the box are left alone.
template <int D>
class Halo {
 public:
  Halo() = default;
  /// `comm` is a Cartesian communicator over the axes 1..D-1; axis 0 is never split.
  Halo(MPI_Comm comm, const Block<D>& block, bool periodic_x);

  /// Exchanges several arrays of the block in one round per axis; edges and corners included.
  void exchange(std::span<double* const> arrays) const;
  void exchange(std::span<float* const> arrays) const;
  void exchange(std::span<std::uint8_t* const> arrays) const;
  template <class T, std::size_t N>
  void exchange(std::array<Storage<T>, N>& fields) const {
    std::array<T*, N> arrays;
    for (std::size_t n = 0; n < N; ++n) arrays[n] = fields[n].data();
    exchange(std::span<T* const>(arrays));
  }
  template <class T>
  void exchange(T* array) const {
    exchange(std::span<T* const>(&array, 1));
  }
  /// Copies the ghosts of one row along x where the box is periodic in x.
  template <class T>
  void wrap_row(T* row) const {
    if (!periodic_x_) return;
    row[-1] = row[width_ - 1];
    row[width_] = row[0];
  }
  /// Whether ghosts beyond this side come from an exchange.
  bool shared(int axis, int side) const {
    return axis == 0 ? periodic_x_ : neighbour_[axis][side] != MPI_PROC_NULL;
  }

 private:
  template <class T>
  void run(std::span<T* const> arrays) const;
  template <class T>
  void exchange_axis(std::span<T* const> arrays, int axis) const;
  template <class T, class Visit>
  void for_runs(std::span<T* const> arrays, int axis, int c, Visit&& visit) const;
  template <class T>
  void copy_axis(T* array, int axis) const;

  MPI_Comm comm_ = MPI_COMM_NULL;
  Block<D> block_;
  int width_ = 0, rank_ = 0;
  bool periodic_x_ = false;
  std::array<std::array<int, 2>, D> neighbour_{};
  mutable std::array<std::vector<std::byte>, 2> inbox_, outbox_;  ///< to and from either side
};

}  // namespace washtub
