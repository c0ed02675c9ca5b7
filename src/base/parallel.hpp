#pragma once
#include <mpi.h>

#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

namespace washtub {

/// The ranks that compute together. Reductions are collective.
class Parallel {
 public:
  explicit Parallel(MPI_Comm comm = MPI_COMM_WORLD) : comm_(comm) {
    MPI_Comm_rank(comm, &rank_);
    MPI_Comm_size(comm, &size_);
  }

  MPI_Comm comm() const { return comm_; }
  int rank() const { return rank_; }
  int size() const { return size_; }
  bool root() const { return rank_ == 0; }

  double sum(double value) const { return reduce(value, MPI_SUM); }
  double max(double value) const { return reduce(value, MPI_MAX); }
  double min(double value) const { return reduce(value, MPI_MIN); }
  bool any(bool value) const { return reduce(value ? 1.0 : 0.0, MPI_MAX) > 0; }

  /// Replaces every entry by its sum over the ranks.
  void sum(std::span<double> values) const {
    if (size_ > 1)
      MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE,
                    MPI_SUM, comm_);
  }
  /// Replaces every entry by its least over the ranks.
  void min(std::span<double> values) const {
    if (size_ > 1)
      MPI_Allreduce(MPI_IN_PLACE, values.data(), static_cast<int>(values.size()), MPI_DOUBLE,
                    MPI_MIN, comm_);
  }
  /// Replaces a list by those of all ranks, one after the other.
  template <class T>
  void gather(std::vector<T>& list) const {
    static_assert(std::is_trivially_destructible_v<T>, "bytes are all that is sent");
    const int mine = static_cast<int>(list.size() * sizeof(T));
    std::vector<int> bytes(static_cast<std::size_t>(size_)), first(bytes.size());
    MPI_Allgather(&mine, 1, MPI_INT, bytes.data(), 1, MPI_INT, comm_);
    std::exclusive_scan(bytes.begin(), bytes.end(), first.begin(), 0);
    std::vector<T> all(static_cast<std::size_t>(first.back() + bytes.back()) / sizeof(T));
    MPI_Allgatherv(list.data(), mine, MPI_BYTE, all.data(), bytes.data(), first.data(), MPI_BYTE,
                   comm_);
    list.swap(all);
  }

 private:
  double reduce(double value, MPI_Op op) const {
    if (size_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, op, comm_);
    return value;
  }

  MPI_Comm comm_;
  int rank_ = 0, size_ = 1;
};

}  // namespace washtub
