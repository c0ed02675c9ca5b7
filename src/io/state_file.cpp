#include "io/state_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <filesystem>

#include "base/error.hpp"
#include "io/hdf5_file.hpp"

namespace washtub {
namespace {

hid_t type_of(Number kind) {
  switch (kind) {
    case Number::real64:
      return H5T_NATIVE_DOUBLE;
    case Number::real32:
      return H5T_NATIVE_FLOAT;
    case Number::int64:
      return H5T_NATIVE_LONG;
    case Number::int32:
      return H5T_NATIVE_INT;
    case Number::byte:
      break;
  }
  return H5T_NATIVE_UCHAR;
}

using Triple = GridPart::Triple;

Hdf5Handle space(const Triple& extent) {
  std::array<hsize_t, 3> n{};
  std::copy(extent.begin(), extent.end(), n.begin());
  return {H5Screate_simple(3, n.data(), nullptr), H5Sclose};
}

herr_t select(hid_t space, const Triple& offset, const Triple& count) {
  std::array<hsize_t, 3> from{}, n{};
  std::copy(offset.begin(), offset.end(), from.begin());
  std::copy(count.begin(), count.end(), n.begin());
  return H5Sselect_hyperslab(space, H5S_SELECT_SET, from.data(), nullptr, n.data(), nullptr);
}

Hdf5Handle create(const std::string& path, MPI_Comm comm, std::size_t reserved) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_userblock(creation, reserved);
  return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, shared_access(comm)), H5Fclose};
}

Hdf5Handle open(const std::string& path) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  return {H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
}

}  // namespace

StateWriter::StateWriter(const std::string& path, MPI_Comm comm, std::size_t reserved)
    : file_(create(path, comm, reserved)) {
  MPI_Comm_rank(comm, &rank_);
  failed(file_);
}

bool StateWriter::failed(long long result) {
  if (result >= 0) return false;
  if (reason_.empty()) reason_ = hdf5_error();
  return true;
}

std::string StateWriter::close() {
  failed(file_.close());
  return reason_;
}

void StateWriter::enter(const std::string& prefix) {
  const Hdf5Handle group(H5Gcreate2(file_, prefix.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose);
  failed(group);
}

/// Rank 0 writes; every rank takes part in making the dataset.
void StateWriter::list(const std::string& path, Number kind, void* data, std::size_t count) {
  const hsize_t n = count;
  const Hdf5Handle space(H5Screate_simple(1, &n, nullptr), H5Sclose);
  const Hdf5Handle dataset(
      H5Dcreate2(file_, path.c_str(), type_of(kind), space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  if (!failed(dataset) && rank_ == 0 && count > 0)
    failed(H5Dwrite(dataset, type_of(kind), H5S_ALL, H5S_ALL, H5P_DEFAULT, data));
}

void StateWriter::grid_values(const std::string& path, Number kind, void* data,
                              const GridPart& part) {
  const Hdf5Handle on_file = space(part.extent), in_memory = space(part.memory);
  const Hdf5Handle dataset(H5Dcreate2(file_, path.c_str(), type_of(kind), on_file, H5P_DEFAULT,
                                      H5P_DEFAULT, H5P_DEFAULT),
                           H5Dclose);
  Triple inner;
  for (std::size_t a = 0; a < 3; ++a) inner[a] = part.offset[a] - part.near[a];
  const Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  failed(select(on_file, part.offset, part.count));
  failed(select(in_memory, inner, part.count));
  if (!failed(dataset))
    failed(H5Dwrite(dataset, type_of(kind), in_memory, on_file, transfer, data));
}

StateReader::StateReader(const std::string& path, const std::string& within)
    : Archive(within), path_(path), file_(open(path)) {
  if (file_ < 0) throw InputError(fmt::format("cannot read {}: {}", path, hdf5_error()));
}

void StateReader::check(long long result, const std::string& path) const {
  if (result < 0)
    throw InputError(fmt::format("cannot read {}: {}: {}", path_, path, hdf5_error()));
}

Hdf5Handle StateReader::dataset(const std::string& path) const {
  Hdf5Handle dataset(H5Dopen2(file_, path.c_str(), H5P_DEFAULT), H5Dclose);
  if (dataset < 0) throw InputError(fmt::format("cannot read {}: it has no {}", path_, path));
  if (!is_number({H5Dget_type(dataset), H5Tclose}))
    throw InputError(fmt::format("cannot read {}: {} does not hold numbers", path_, path));
  return dataset;
}

std::size_t StateReader::length(const std::string& path, std::size_t) {
  const Hdf5Handle from = dataset(path), on_file(H5Dget_space(from), H5Sclose);
  const auto count = H5Sget_simple_extent_npoints(on_file);
  check(count, path);
  if (static_cast<std::uintmax_t>(count) > std::filesystem::file_size(path_))
    throw InputError(fmt::format("cannot read {}: {} is larger than the file", path_, path));
  return static_cast<std::size_t>(count);
}

void StateReader::list(const std::string& path, Number kind, void* data, std::size_t count) {
  const std::size_t there = length(path, count);
  if (there != count)
    throw InputError(fmt::format("{}: {} has {} values, expected {}", path_, path, there, count));
  if (count > 0)
    check(H5Dread(dataset(path), type_of(kind), H5S_ALL, H5S_ALL, H5P_DEFAULT, data), path);
}

void StateReader::grid_values(const std::string& path, Number kind, void* data,
                              const GridPart& part) {
  const Hdf5Handle from = dataset(path), on_file(H5Dget_space(from), H5Sclose);
  std::array<hsize_t, 3> extent{};
  const bool a_grid = H5Sget_simple_extent_ndims(on_file) == 3 &&
                      H5Sget_simple_extent_dims(on_file, extent.data(), nullptr) == 3;
  if (!a_grid || !std::equal(extent.begin(), extent.end(), part.extent.begin()))
    throw InputError(
        fmt::format("{}: the grid of {} is {}, that of the case {} (with a layer "
                    "beyond each side)",
                    path_, path, fmt::join(extent, " x "), fmt::join(part.extent, " x ")));
  const Hdf5Handle in_memory = space(part.memory);
  check(select(on_file, part.near, part.near_count), path);
  check(select(in_memory, {}, part.near_count), path);
  check(H5Dread(from, type_of(kind), in_memory, on_file, H5P_DEFAULT, data), path);
}

}  // namespace washtub
