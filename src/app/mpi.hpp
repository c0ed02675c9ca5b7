#pragma once
#include <mpi.h>

namespace washtub {

/// Initialises MPI for as long as it lives.
struct Mpi {
  Mpi() { MPI_Init(nullptr, nullptr); }
  ~Mpi() { MPI_Finalize(); }
  Mpi(const Mpi&) = delete;
  Mpi& operator=(const Mpi&) = delete;
};

}  // namespace washtub
