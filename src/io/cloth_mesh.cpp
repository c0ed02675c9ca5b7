#include "io/cloth_mesh.hpp"

#include <algorithm>

namespace washtub {
namespace {

void append(std::vector<double>& to, std::span<const double> values) {
  to.insert(to.end(), values.begin(), values.end());
}

int intervals(const ClothPiece& p, int axis) {
  return p.closed[axis] ? p.extent[axis] : p.extent[axis] - 1;
}

/// The whole dataset on rank 0, nothing on the others; `width` entries per row, 0: one dimension.
Slab on_root(bool root, std::size_t rows, std::size_t width) {
  Slab slab{{rows}, {0}, {root ? rows : 0}};
  if (width == 0) return slab;
  slab.extent.push_back(width);
  slab.offset.push_back(0);
  slab.count.push_back(width);
  return slab;
}

}  // namespace

ClothMesh::ClothMesh(const std::vector<ClothPiece>& all, int dimension) {
  topology.corners = dimension == 3 ? 4 : 2;
  for (const ClothPiece& p : all) {
    const int first = static_cast<int>(positions.size() / 3);
    const int number = static_cast<int>(pieces.size() / 3);
    pieces.insert(pieces.end(), {first, p.extent[0], p.extent[1]});
    for (std::size_t i = 0; i < p.positions.size(); ++i) {
      positions.push_back(p.positions[i]);
      if (dimension == 2 && i % 2 == 1) positions.push_back(0);
    }
    if (dimension == 3)
      add_plate(p, first, number);
    else
      add_thread(p, first, number);
    values.resize(std::max(values.size(), p.values.size()));
    for (std::size_t f = 0; f < p.values.size(); ++f) append(values[f], p.values[f]);
  }
  topology.nodes = positions.size() / 3;
  topology.cells = piece.size();
}

void ClothMesh::add_plate(const ClothPiece& p, int first, int number) {
  const auto [nr, ns] = p.extent;
  for (int j = 0; j < intervals(p, 1); ++j)
    for (int i = 0; i < intervals(p, 0); ++i) {
      const int right = (i + 1) % nr, below = first + nr * j, above = first + nr * ((j + 1) % ns);
      cells.insert(cells.end(), {below + i, below + right, above + right, above + i});
      piece.push_back(number);
    }
}

void ClothMesh::add_thread(const ClothPiece& p, int first, int number) {
  for (int j = 0; j < intervals(p, 1); ++j) {
    cells.insert(cells.end(), {first + j, first + (j + 1) % p.extent[1]});
    piece.push_back(number);
  }
}

ClothTopology write_cloth(Hdf5File& file, const ClothMesh& mesh,
                          const std::vector<FieldDescription>& fields, const Parallel& parallel) {
  std::array<long, 3> size = {static_cast<long>(mesh.topology.nodes),
                              static_cast<long>(mesh.topology.cells),
                              static_cast<long>(mesh.pieces.size() / 3)};
  MPI_Bcast(size.data(), 3, MPI_LONG, 0, parallel.comm());
  const auto nodes = static_cast<std::size_t>(size[0]), cells = static_cast<std::size_t>(size[1]);
  const bool root = parallel.root();
  const ClothTopology written{nodes, cells, mesh.topology.corners};
  if (cells == 0) return written;
  const auto mine = [root](const auto& values) {
    return std::span(values.data(), root ? values.size() : 0);
  };
  const auto corners = static_cast<std::size_t>(written.corners);
  file.group("cloth");
  file.write("cloth/positions", "m", on_root(root, nodes, 3), mine(mesh.positions));
  for (std::size_t f = 0; f < fields.size(); ++f)
    file.write("cloth", fields[f], on_root(root, nodes, 0),
               root && f < mesh.values.size() ? std::span<const double>(mesh.values[f])
                                              : std::span<const double>());
  file.write("cloth/cells", "", on_root(root, cells, corners), mine(mesh.cells));
  file.write("cloth/piece", "", on_root(root, cells, 0), mine(mesh.piece));
  const auto pieces = static_cast<std::size_t>(size[2]);
  file.write("cloth/pieces", "", on_root(root, pieces, 3), mine(mesh.pieces));
  return written;
}

}  // namespace washtub
