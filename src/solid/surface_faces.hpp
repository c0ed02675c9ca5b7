#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "grid/grid.hpp"

namespace washtub {

/// A face that a solid closes or narrows.
template <int D>
struct SurfaceFace {
  long p;              ///< memory position
  Vec<D> x;            ///< its centre [m]
  std::uint8_t edges;  ///< bit 2 d + side: the edge to its neighbour on this side (0 lower, 1
                       ///< upper) along d lies inside the box

  bool has_edge(int d, int side) const { return (edges >> (2 * d + side) & 1) != 0; }
};

/// Faces normal to one axis that lie in solids, in the order of memory.
template <int D>
class SurfaceFaces {
 public:
  SurfaceFaces(const Grid<D>& grid, int axis) : grid_(grid), axis_(axis) {}

  /// A face of this rank, by its cell in the block.
  SurfaceFace<D> face(const Index<D>& cell) const;

  void clear() { faces_.clear(); }
  /// Some face has fully opened.
  void release() { released_ = true; }
  /// A face that has begun to close; takes part from the next update() on.
  void add(const Index<D>& cell) { added_.push_back(face(cell)); }
  /// Takes up what was added and drops faces that are fully open.
  void update(const float* open);

  auto begin() const { return faces_.begin(); }
  auto end() const { return faces_.end(); }

 private:
  const Grid<D>& grid_;
  int axis_;
  std::vector<SurfaceFace<D>> faces_, added_, merged_;
  bool released_ = false;
};

}  // namespace washtub
