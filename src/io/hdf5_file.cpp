#include "io/hdf5_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numeric>

namespace washtub {
namespace {

herr_t keep_description(unsigned, const H5E_error2_t* record, void* text) {
  auto& description = *static_cast<std::string*>(text);
  if (description.empty() && record->desc != nullptr) description = record->desc;
  return 0;
}

hsize_t product(const std::vector<hsize_t>& n) {
  return std::accumulate(n.begin(), n.end(), hsize_t{1}, std::multiplies<>());
}

}  // namespace

std::string hdf5_error() {
  std::string text;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_description, &text);
  return text.empty() ? "HDF5 failed" : text;
}

Hdf5Handle shared_access(MPI_Comm comm) {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fapl_mpio(access, comm, MPI_INFO_NULL);
  H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_LATEST);  // the first with checksums
  return access;
}

bool is_number(Hdf5Handle type) {
  const H5T_class_t kind = H5Tget_class(type);
  return (kind == H5T_INTEGER || kind == H5T_FLOAT) && H5Tget_size(type) <= sizeof(double);
}

Hdf5File::Hdf5File(const std::string& path, MPI_Comm comm) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, shared_access(comm));
  failed(file_);
}

bool Hdf5File::failed(long long result) {
  if (result >= 0) return false;
  if (reason_.empty()) reason_ = hdf5_error();
  return true;
}

std::string Hdf5File::close() {
  if (file_ >= 0 && failed(H5Fclose(file_))) hdf5_lost = true;
  file_ = -1;
  return reason_;
}

void Hdf5File::group(const std::string& name) {
  const Hdf5Handle group(H5Gcreate2(file_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
                         H5Gclose);
  failed(group);
}

void Hdf5File::attribute(const std::string& name, double value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(
      H5Acreate2(file_, name.c_str(), H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  if (!failed(attribute)) failed(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value));
}

void Hdf5File::describe(const std::string& name, const FieldDescription& field) {
  const Hdf5Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), H5Dclose);
  if (failed(dataset)) return;
  text(dataset, "label", field.label);
  text(dataset, "meaning", field.meaning);
}

void Hdf5File::text(hid_t dataset, const char* name, const std::string& text) {
  if (text.empty()) return;
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  H5Tset_size(type, text.size());
  const Hdf5Handle attribute(H5Acreate2(dataset, name, type, space, H5P_DEFAULT, H5P_DEFAULT),
                             H5Aclose);
  if (!failed(attribute)) failed(H5Awrite(attribute, type, text.data()));
}

void Hdf5File::write(const std::string& name, const std::string& unit_text, const Slab& slab,
                     hid_t type, const void* values, std::size_t size) {
  const Hdf5Handle space(
      H5Screate_simple(static_cast<int>(slab.extent.size()), slab.extent.data(), nullptr),
      H5Sclose);
  const Hdf5Handle dataset(
      H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Dclose);
  if (failed(dataset)) return;
  text(dataset, "unit", unit_text);
  if (size == product(slab.count)) return put(dataset, slab, type, values);
  if (reason_.empty())
    reason_ = fmt::format("{}: {} values for {} entries", name, size, product(slab.count));
  put(dataset, {slab.extent, slab.offset, std::vector<hsize_t>(slab.extent.size(), 0)}, type,
      nullptr);
}

void Hdf5File::put(hid_t dataset, const Slab& slab, hid_t type, const void* values) {
  const Hdf5Handle on_file(H5Dget_space(dataset), H5Sclose);
  const Hdf5Handle in_memory(
      H5Screate_simple(static_cast<int>(slab.count.size()), slab.count.data(), nullptr), H5Sclose);
  if (product(slab.count) == 0) {
    H5Sselect_none(on_file);
    H5Sselect_none(in_memory);
  } else {
    failed(H5Sselect_hyperslab(on_file, H5S_SELECT_SET, slab.offset.data(), nullptr,
                               slab.count.data(), nullptr));
  }
  const Hdf5Handle transfer(H5Pcreate(H5P_DATASET_XFER), H5Pclose);
  H5Pset_dxpl_mpio(transfer, H5FD_MPIO_COLLECTIVE);
  failed(H5Dwrite(dataset, type, in_memory, on_file, transfer, values));
}

}  // namespace washtub
