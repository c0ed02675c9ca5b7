#include "base/tally.hpp"

#include <algorithm>

namespace washtub {
namespace {

void merge(void* in, void* in_out, int* count, MPI_Datatype*) {
  const auto* from = static_cast<const Tally*>(in);
  auto* to = static_cast<Tally*>(in_out);
  for (int t = 0; t < *count; ++t)
    for (std::size_t i = 0; i < to[t].sum.size(); ++i) {
      to[t].sum[i] += from[t].sum[i];
      to[t].max[i] = std::max(to[t].max[i], from[t].max[i]);
    }
}

/// What MPI needs to know of a Tally; made once, for as long as MPI runs.
struct Types {
  MPI_Datatype value;
  MPI_Op op;
  Types() {
    MPI_Type_contiguous(sizeof(Tally) / sizeof(double), MPI_DOUBLE, &value);
    MPI_Type_commit(&value);
    MPI_Op_create(merge, 1, &op);
  }
};

}  // namespace

void combine(const Parallel& parallel, Tally& tally) {
  if (parallel.size() == 1) return;
  static const Types types;
  MPI_Allreduce(MPI_IN_PLACE, &tally, 1, types.value, types.op, parallel.comm());
}

}  // namespace washtub
