# Every library the project uses; `washtub` installs their Debian packages.
set(HDF5_PREFER_PARALLEL ON)
find_package(MPI REQUIRED COMPONENTS CXX)
find_package(HDF5 REQUIRED COMPONENTS C)
find_package(Eigen3 3.4 REQUIRED)
find_package(fmt REQUIRED)
find_package(spdlog REQUIRED)
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(GTest REQUIRED)
find_package(benchmark REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(tomlplusplus REQUIRED IMPORTED_TARGET tomlplusplus)
pkg_check_modules(muparser REQUIRED IMPORTED_TARGET muparser)
find_package(ZLIB REQUIRED)
find_package(TBB REQUIRED)
find_package(Imath REQUIRED)  # of OpenVDB
find_library(UDUNITS2_LIBRARY udunits2 REQUIRED)
find_library(OPENVDB_LIBRARY openvdb REQUIRED)
find_library(B64_LIBRARY b64 REQUIRED)

# Third-party headers are not held to our warnings.
add_library(washtub_libraries INTERFACE)
target_include_directories(washtub_libraries SYSTEM INTERFACE
  ${MPI_CXX_INCLUDE_DIRS} ${HDF5_INCLUDE_DIRS} ${EIGEN3_INCLUDE_DIRS})
target_link_libraries(washtub_libraries INTERFACE
  MPI::MPI_CXX ${HDF5_LIBRARIES} Eigen3::Eigen fmt::fmt spdlog::spdlog CLI11::CLI11
  nlohmann_json::nlohmann_json PkgConfig::tomlplusplus PkgConfig::muparser ${UDUNITS2_LIBRARY}
  ZLIB::ZLIB ${B64_LIBRARY} ${OPENVDB_LIBRARY} TBB::tbb Imath::Imath)
target_compile_definitions(washtub_libraries INTERFACE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
