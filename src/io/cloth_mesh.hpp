#pragma once
#include <vector>

#include "io/frame.hpp"

namespace washtub {

/// All pieces of a frame joined into one mesh, as it is written.
struct ClothMesh {
  ClothMesh(const std::vector<ClothPiece>& pieces, int dimension);

  ClothTopology topology;
  std::vector<int> pieces;                  ///< first node and extent of each piece
  std::vector<double> positions;            ///< three per node [m]; z = 0 in the plane
  std::vector<int> cells;                   ///< node numbers, `topology.corners` per cell
  std::vector<int> piece;                   ///< of each cell
  std::vector<std::vector<double>> values;  ///< per node, of each field

 private:
  void add_plate(const ClothPiece& p, int first, int number);
  void add_thread(const ClothPiece& p, int first, int number);
};

/// Writes the mesh that rank 0 holds; the other ranks' meshes are not looked at (collective).
/// Returns what was written, on all ranks.
ClothTopology write_cloth(Hdf5File& file, const ClothMesh& mesh,
                          const std::vector<FieldDescription>& fields, const Parallel& parallel);

}  // namespace washtub
