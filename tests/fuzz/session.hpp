#pragma once
#include <mpi.h>

#include <cstdlib>

namespace washtub::fuzz {

/// What our writers of HDF5 files need: MPI until the end of the program. Signals are left to the
/// sanitizers.
inline void start_session(int* argc, char*** argv) {
  ::setenv("OMPI_MCA_opal_signal", "", 1);
  MPI_Init(argc, argv);
  std::atexit([] { MPI_Finalize(); });
}

}  // namespace washtub::fuzz
