#pragma once
#include <mpi.h>

#include <string>
#include <vector>

#include "base/archive.hpp"
#include "io/hdf5_handle.hpp"

namespace washtub {

/// Writes state to an HDF5 file, all ranks together: a dataset per name, a group per part. Grids
/// are stored whole, so that any number of ranks may read them.
class StateWriter final : public Archive {
 public:
  /// Starts the file with `reserved` bytes (a power of two from 512) left for the caller.
  /// Where it cannot be made close() says so.
  StateWriter(const std::string& path, MPI_Comm comm, std::size_t reserved);
  bool reading() const override { return false; }
  /// Closes the file; the reason of the first failure on this rank, empty if there was none.
  std::string close();

 private:
  void enter(const std::string& prefix) override;
  void list(const std::string& path, Number kind, void* data, std::size_t count) override;
  std::size_t length(const std::string&, std::size_t now) override { return now; }
  void grid_values(const std::string& path, Number kind, void* data, const GridPart& part) override;
  bool failed(long long result);

  Hdf5Handle file_;
  int rank_ = 0;
  std::string reason_;
};

/// Reads what a StateWriter wrote; each rank for itself.
class StateReader final : public Archive {
 public:
  /// @throws InputError where it is no such file
  explicit StateReader(const std::string& path, const std::string& within = "");
  bool reading() const override { return true; }

 private:
  void enter(const std::string&) override {}
  void list(const std::string& path, Number kind, void* data, std::size_t count) override;
  std::size_t length(const std::string& path, std::size_t now) override;
  void grid_values(const std::string& path, Number kind, void* data, const GridPart& part) override;
  Hdf5Handle dataset(const std::string& path) const;
  void check(long long result, const std::string& path) const;

  std::string path_;
  Hdf5Handle file_;
};

}  // namespace washtub
