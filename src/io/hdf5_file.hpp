#pragma once
#include <hdf5.h>
#include <mpi.h>

#include <span>
#include <string>
#include <vector>

#include "io/field.hpp"
#include "io/hdf5_handle.hpp"

namespace washtub {

/// Access to a file that all ranks write together, its structure guarded by checksums.
Hdf5Handle shared_access(MPI_Comm comm);

/// The part of a dataset that one rank writes: `count` entries from `offset` along each dimension,
/// slowest first. A count of zero writes nothing but still takes part.
struct Slab {
  std::vector<hsize_t> extent;  ///< of the whole dataset
  std::vector<hsize_t> offset, count;
};

/// An HDF5 file that all ranks of a communicator write together. Every call is collective. A
/// failure is remembered, not thrown, so that no rank leaves the others waiting; `close` tells.
class Hdf5File {
 public:
  Hdf5File(const std::string& path, MPI_Comm comm);
  ~Hdf5File() { close(); }
  Hdf5File(const Hdf5File&) = delete;
  Hdf5File& operator=(const Hdf5File&) = delete;

  void group(const std::string& name);
  void attribute(const std::string& name, double value);  ///< of the root group
  /// A dataset with its unit as the attribute "unit".
  void write(const std::string& name, const std::string& unit, const Slab& slab,
             std::span<const float> values) {
    write(name, unit, slab, H5T_NATIVE_FLOAT, values.data(), values.size());
  }
  void write(const std::string& name, const std::string& unit, const Slab& slab,
             std::span<const double> values) {
    write(name, unit, slab, H5T_NATIVE_DOUBLE, values.data(), values.size());
  }
  void write(const std::string& name, const std::string& unit, const Slab& slab,
             std::span<const int> values) {
    write(name, unit, slab, H5T_NATIVE_INT, values.data(), values.size());
  }
  /// A field in a group, with its unit, label and meaning as attributes.
  template <class T>
  void write(const std::string& group, const FieldDescription& field, const Slab& slab,
             std::span<const T> values) {
    const std::string name = group + "/" + field.name;
    write(name, field.unit, slab, values);
    describe(name, field);
  }
  /// Closes the file; the reason of the first failure on this rank, empty if there was none.
  std::string close();

 private:
  void write(const std::string& name, const std::string& unit, const Slab& slab, hid_t type,
             const void* values, std::size_t size);
  void put(hid_t dataset, const Slab& slab, hid_t type, const void* values);
  void describe(const std::string& dataset, const FieldDescription& field);
  void text(hid_t dataset, const char* name, const std::string& text);
  /// Remembers the first failure; returns whether `result` was one.
  bool failed(long long result);

  hid_t file_ = -1;
  std::string reason_;
};

}  // namespace washtub
