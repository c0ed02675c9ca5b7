#pragma once
#include <array>
#include <functional>

#include "base/archive.hpp"
#include "base/parallel.hpp"
#include "grid/block.hpp"
#include "grid/halo.hpp"
#include "grid/mesh.hpp"
#include "grid/storage.hpp"

namespace washtub {

using Field = Storage<double>;

/// A vector field: component d lives on the faces normal to axis d.
template <int D>
using Components = std::array<Field, D>;

/// How often each axis must be divisible by two on every rank, so that multigrid levels line up.
template <int D>
using Granularity = Index<D>;

/// The mesh, cut into one block per rank along y and z (rows along x stay whole).
template <int D>
class Grid {
 public:
  /// `unit[d]`: block edges lie on multiples of it.
  /// @throws InputError when there are more ranks than the mesh can be cut for.
  Grid(const Mesh<D>& mesh, const Parallel& parallel, const Granularity<D>& unit);
  ~Grid();
  Grid(const Grid&) = delete;
  Grid& operator=(const Grid&) = delete;

  const Mesh<D>& mesh() const { return mesh_; }
  const Block<D>& block() const { return block_; }
  const Parallel& parallel() const { return parallel_; }
  const Halo<D>& halo() const { return halo_; }
  MPI_Comm comm() const { return comm_; }
  const Index<D>& ranks() const { return ranks_; }

  /// Whether the block ends at this side of the box (0 lower, 1 upper) and the side is a boundary.
  bool at_side(int axis, int side) const {
    return !mesh_.periodic[axis] &&
           (side == 0 ? block_.offset[axis] == 0
                      : block_.offset[axis] + block_.count[axis] == mesh_.cells[axis]);
  }
  /// Where a field of this grid lies in memory and in the whole.
  GridPart part() const;
  Field make_field() const { return Field(static_cast<std::size_t>(block_.size)); }
  Vec<D> position(const Index<D>& local, int face = -1) const {
    Index<D> c = local;
    for (int d = 0; d < D; ++d) c[d] += block_.offset[d];
    return mesh_.position(c, face);
  }

 private:
  Mesh<D> mesh_;
  Parallel parallel_;
  Index<D> ranks_{};
  MPI_Comm comm_ = MPI_COMM_NULL;
  Block<D> block_;
  Halo<D> halo_;
};

/// Ranks along each axis (1 along x) for which the largest block is smallest.
/// @throws InputError when `size` ranks cannot be placed.
template <int D>
Index<D> choose_ranks(const Index<D>& cells, const Granularity<D>& unit, int size);

/// First cell and number of cells of part `part` of `parts` along an axis of n cells.
std::array<int, 2> cut_axis(int n, int unit, int parts, int part);

}  // namespace washtub
