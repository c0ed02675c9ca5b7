#include "io/frame.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/error.hpp"
#include "io/agree.hpp"
#include "io/cloth_mesh.hpp"
#include "io/file.hpp"
#include "io/reserve.hpp"

namespace washtub {
namespace {

namespace fs = std::filesystem;

std::string relative_path(int number) { return fmt::format("frames/frame_{:06d}.h5", number); }

/// Bytes of a frame's file, and some to spare for the library's own data.
std::size_t file_size(const FluidGrid& grid, const FluidBlock& fluid, const ClothMesh& cloth) {
  std::size_t cells = 1, components = 0;
  for (const int n : grid.cells) cells *= static_cast<std::size_t>(n);
  for (const FieldBlock& block : fluid.fields)
    components += static_cast<std::size_t>(block.field.components);
  const std::size_t nodes = cloth.topology.nodes * (3 + cloth.values.size()) * sizeof(double);
  const std::size_t quads = (cloth.cells.size() + cloth.piece.size()) * sizeof(int);
  return cells * components * sizeof(float) + nodes + quads + 65536;
}

/// What the index lists of a frame.
FrameFields fields_of(const Frame& frame) {
  FrameFields fields{{}, frame.cloth_fields};
  for (const FieldBlock& block : frame.fluid.fields) fields.fluid.push_back(block.field);
  return fields;
}

std::vector<FrameNumber> numbers_of(const Frame& frame) {
  std::vector<FrameNumber> numbers;
  for (const SolidAngle& s : frame.solids)
    numbers.push_back({fmt::format("angle of {} [rad]", s.name), s.angle});
  numbers.insert(numbers.end(), frame.numbers.begin(), frame.numbers.end());
  return numbers;
}

/// Slowest dimension first; `components` per cell, 0: scalar.
Slab fluid_slab(const std::array<int, 3>& cells, const FluidBlock& block, hsize_t components) {
  Slab slab;
  for (int d = 2; d >= 0; --d) {
    slab.extent.push_back(static_cast<hsize_t>(cells[d]));
    slab.offset.push_back(static_cast<hsize_t>(block.offset[d]));
    slab.count.push_back(static_cast<hsize_t>(block.count[d]));
  }
  if (components == 0) return slab;
  slab.extent.push_back(components);
  slab.offset.push_back(0);
  slab.count.push_back(components);
  return slab;
}

}  // namespace

FrameWriter::FrameWriter(const std::string& directory, const Parallel& parallel, int dimension,
                         const FluidGrid& grid)
    : directory_(directory), parallel_(parallel), dimension_(dimension), grid_(grid) {
  std::error_code error;
  const std::string frames = directory_ + "/frames";
  if (parallel_.root()) fs::create_directory(frames, error);
  agree(parallel_,
        error ? fmt::format("cannot write {}: {}", frames, error.message()) : std::string());
}

std::string FrameWriter::path(int number) const { return directory_ + "/" + relative_path(number); }

void FrameWriter::resume(int frames) {
  if (parallel_.root()) {
    std::ifstream file(directory_ + "/frames.xdmf");
    const std::istreambuf_iterator<char> begin(file), end;
    index_.restore(std::string(begin, end), static_cast<std::size_t>(frames));
    frames_ = static_cast<int>(index_.frames());
    if (file.is_open()) replace_file(directory_ + "/frames.xdmf", index_.text());
    std::error_code ignored;
    for (int n = frames_; fs::remove(path(n), ignored); ++n)
      ;
  }
  MPI_Bcast(&frames_, 1, MPI_INT, 0, parallel_.comm());
}

void FrameWriter::write_fluid(Hdf5File& file, const FluidBlock& fluid) const {
  file.group("fluid");
  for (const auto& [field, values] : fluid.fields) {
    const int width = field.components > 1 ? field.components : 0;
    file.write("fluid", field, fluid_slab(grid_.cells, fluid, static_cast<hsize_t>(width)), values);
  }
}

void FrameWriter::write(const Frame& frame) {
  const std::string target = path(frames_);
  const ClothMesh mesh(parallel_.root() ? frame.cloth : std::vector<ClothPiece>(), dimension_);
  const std::size_t bytes = file_size(grid_, frame.fluid, mesh);
  reserve_file(target, bytes, parallel_);
  Hdf5File file(target + ".part", parallel_.comm());
  reserve_file(target, bytes, parallel_);
  file.attribute("time [s]", frame.time);
  for (const FrameNumber& number : numbers_of(frame)) file.attribute(number.name, number.value);
  write_fluid(file, frame.fluid);
  const ClothTopology cloth = write_cloth(file, mesh, frame.cloth_fields, parallel_);
  finish(file.close(), frame, cloth);
}

/// Renames the finished file and lists it; on failure nothing of the frame is left.
void FrameWriter::publish(const Frame& frame, const ClothTopology& cloth) {
  const std::string target = path(frames_);
  publish_file(target);
  index_.add(frame.time, relative_path(frames_), grid_, cloth, fields_of(frame), numbers_of(frame));
  try {
    replace_file(directory_ + "/frames.xdmf", index_.text());
    if (frames_ == 0) replace_file(directory_ + "/paraview.xdmf2", paraview_index());
  } catch (const RunError&) {
    index_.drop_last();
    std::remove(target.c_str());
    throw;
  }
}

/// Puts the written file in its place, or removes it if any rank failed.
void FrameWriter::finish(const std::string& failure, const Frame& frame,
                         const ClothTopology& cloth) {
  const std::string target = path(frames_);
  std::string reason = failure;
  if (!reason.empty()) reason = fmt::format("cannot write {}: {}", target, reason);
  if (!parallel_.any(!reason.empty()) && parallel_.root()) {
    try {
      publish(frame, cloth);
    } catch (const RunError& error) {
      reason = error.what();
    }
  }
  if (parallel_.root()) std::remove((target + ".part").c_str());
  agree(parallel_, reason);
  ++frames_;
}

}  // namespace washtub
