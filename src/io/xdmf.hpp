#pragma once
#include <array>
#include <string>
#include <vector>

#include "base/vec.hpp"
#include "grid/mesh.hpp"
#include "io/field.hpp"

namespace washtub {

/// The fluid's cells as ParaView gets them: always in space. A plane case is a slab of one cell
/// just below z = 0, where its cloth lies, since readers place plane meshes in the y-z plane.
struct FluidGrid {
  std::array<int, 3> cells{};
  Vec<3> lower, spacing;  ///< [m]
};

FluidGrid fluid_grid(const Mesh<2>& mesh);
FluidGrid fluid_grid(const Mesh<3>& mesh);

/// What frames.xdmf says about the cloth of one frame.
struct ClothTopology {
  std::size_t nodes = 0, cells = 0;  ///< of all pieces together
  int corners = 4;                   ///< nodes of a cell: 4 in a plate, 2 in a thread
};

/// The fields of a frame, per cell of the fluid and per node of the cloth.
struct FrameFields {
  std::vector<FieldDescription> fluid, cloth;
};

/// An angle of a solid, or another number that belongs to a whole frame.
struct FrameNumber {
  std::string name;  ///< with its unit, "angle of agitator [rad]"
  double value = 0;
};

/// frames.xdmf (XDMF 3): two meshes, "fluid" and "cloth", each a collection over time, so that
/// readers know them by the same name at every time. Their values are in the frames' HDF5 files.
/// Paths are relative to the directory of frames.xdmf.
class FrameIndex {
 public:
  struct Entry {
    double time = 0;           ///< [s]
    std::string fluid, cloth;  ///< their <Grid> elements; "" where a run has no cloth
  };

  /// `file`: path of the frame's HDF5 file, relative.
  void add(double time, const std::string& file, const FluidGrid& fluid, const ClothTopology& cloth,
           const FrameFields& fields, const std::vector<FrameNumber>& numbers);
  void drop_last() { entries_.pop_back(); }
  /// Takes over the first `frames` frames that the text of an earlier frames.xdmf lists.
  void restore(const std::string& text, std::size_t frames);
  std::size_t frames() const { return entries_.size(); }
  std::string text() const;

 private:
  std::vector<Entry> entries_;
};

/// Text of paraview.xdmf2, which includes the whole of frames.xdmf. ParaView has one reader for
/// this ending and so opens the file at once; for .xdmf it has three and asks which.
std::string paraview_index();

}  // namespace washtub
