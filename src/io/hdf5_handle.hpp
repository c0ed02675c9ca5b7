#pragma once
#include <hdf5.h>

#include <string>
#include <utility>

namespace washtub {

/// Whether the library has failed to close something, as on a full disk. It tries again at its own
/// end, or that of MPI, and takes the process down with it: such a process must leave by _Exit.
inline bool hdf5_lost = false;

/// A handle of the HDF5 library, closed at the end of its scope.
class Hdf5Handle {
 public:
  Hdf5Handle(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Hdf5Handle(Hdf5Handle&& other) noexcept
      : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  ~Hdf5Handle() { close(); }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  operator hid_t() const { return id_; }
  /// Negative where that failed.
  herr_t close() {
    const herr_t result = id_ >= 0 ? close_(std::exchange(id_, -1)) : 0;
    hdf5_lost = hdf5_lost || result < 0;
    return result;
  }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Whether values of a type, which is closed, are numbers. In a damaged file they may be of any
/// size, and the library takes memory for them.
bool is_number(Hdf5Handle type);

/// What the library says of the innermost cause of its last failure.
std::string hdf5_error();

}  // namespace washtub
