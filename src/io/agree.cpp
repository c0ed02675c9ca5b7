#include "io/agree.hpp"

#include "base/error.hpp"

namespace washtub {
namespace {

std::string from_rank(const Parallel& parallel, std::string text, int rank) {
  int length = static_cast<int>(text.size());
  MPI_Bcast(&length, 1, MPI_INT, rank, parallel.comm());
  text.resize(static_cast<std::size_t>(length));
  MPI_Bcast(text.data(), length, MPI_CHAR, rank, parallel.comm());
  return text;
}

}  // namespace

void agree(const Parallel& parallel, const std::string& reason) {
  int first = reason.empty() ? parallel.size() : parallel.rank();
  MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_INT, MPI_MIN, parallel.comm());
  if (first < parallel.size()) throw RunError(from_rank(parallel, reason, first));
}

std::string from_root(const Parallel& parallel, std::string text) {
  return from_rank(parallel, std::move(text), 0);
}

}  // namespace washtub
