#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "base/parallel.hpp"
#include "io/field.hpp"
#include "io/hdf5_file.hpp"
#include "io/xdmf.hpp"

namespace washtub {

/// Cell-centred values of one rank's cells, x fastest. In plane cases the third offset is 0 and
/// the third count 1.
struct FluidBlock {
  std::array<int, 3> offset{}, count{};  ///< cells, in the whole grid
  std::vector<FieldBlock> fields;        ///< the same ones on all ranks
};

/// One piece of cloth; node (i, j) has number i + extent[0] j.
struct ClothPiece {
  std::array<int, 2> extent{};                  ///< nodes along r and s; {1, n} for a thread
  std::span<const double> positions;            ///< `dimension` coordinates per node [m]
  std::vector<std::span<const double>> values;  ///< per node, of each of Frame::cloth_fields
  std::array<bool, 2> closed{};  ///< whether the last node meets the first one, along r and s
};

struct SolidAngle {
  std::string name;
  double angle = 0;  ///< swept since t = 0 [rad]
};

struct Frame {
  double time = 0;                             ///< [s]
  FluidBlock fluid;                            ///< this rank's
  std::vector<FieldDescription> cloth_fields;  ///< scalars, the same on all ranks
  std::vector<ClothPiece> cloth;               ///< all pieces, looked at on rank 0 only
  std::vector<SolidAngle> solids;              ///< the same on all ranks
  std::vector<FrameNumber> numbers = {};       ///< further ones of the whole frame, likewise
};

/// Writes the frames of a run, each to its own file frames/frame_000000.h5 under the output
/// directory, and keeps frames.xdmf up to date, so that ParaView can open it, by way of
/// paraview.xdmf2, at any time:
///   attributes of /   "time [s]", "angle of NAME [rad]", and `numbers`
///   /fluid/FIELD (nz, ny, nx), vectors (nz, ny, nx, 3): 32-bit
///   /cloth/positions (nodes, 3) [m], FIELD (nodes): all pieces one after the other; cells
///     (cells, 4 or 2) node numbers; piece (cells)
///   /cloth/pieces (pieces, 3): first node and extent of each piece
/// A field has its unit, label and meaning as attributes. No /cloth where there is no cloth.
class FrameWriter {
 public:
  /// `dimension` 2 or 3. Creates the directory `frames` (collective).
  /// @throws RunError with path and reason, on all ranks
  FrameWriter(const std::string& directory, const Parallel& parallel, int dimension,
              const FluidGrid& grid);

  /// Goes on after an interrupted run, behind its first `frames` frames; forgets later ones
  /// (collective). Fewer may be left of them.
  void resume(int frames);

  /// Collective. On return the frame is in place, complete, and listed in frames.xdmf.
  /// @throws RunError with path and reason, on all ranks; then no part of the frame is left
  void write(const Frame& frame);

  int frames() const { return frames_; }  ///< written so far

 private:
  void write_fluid(Hdf5File& file, const FluidBlock& fluid) const;
  void publish(const Frame& frame, const ClothTopology& cloth);
  void finish(const std::string& failure, const Frame& frame, const ClothTopology& cloth);
  std::string path(int number) const;

  std::string directory_;
  Parallel parallel_;
  int dimension_;
  FluidGrid grid_;
  FrameIndex index_;  ///< on rank 0
  int frames_ = 0;
};

}  // namespace washtub
