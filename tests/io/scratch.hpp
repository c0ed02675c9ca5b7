#pragma once
#include <mpi.h>
#include <stdlib.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace washtub {

/// A new empty directory, removed at the end: each rank's own, or one for all of them.
class Scratch {
 public:
  enum class For { this_rank, all_ranks };
  explicit Scratch(For whom = For::this_rank) : shared_(whom == For::all_ranks) {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    char name[64] = "/tmp/washtub_test_XXXXXX";
    if ((!shared_ || rank_ == 0) && mkdtemp(name) == nullptr) MPI_Abort(MPI_COMM_WORLD, 1);
    if (shared_) MPI_Bcast(name, sizeof name, MPI_CHAR, 0, MPI_COMM_WORLD);
    path_ = name;
  }
  ~Scratch() {
    if (shared_) MPI_Barrier(MPI_COMM_WORLD);
    if (!shared_ || rank_ == 0) std::filesystem::remove_all(path_);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  std::string operator/(const std::string& name) const { return path_ + "/" + name; }
  const std::string& path() const { return path_; }
  /// Entries in the directory.
  long entries() const { return std::distance(std::filesystem::directory_iterator(path_), {}); }

 private:
  bool shared_;
  int rank_ = 0;
  std::string path_;
};

inline std::string contents(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace washtub
