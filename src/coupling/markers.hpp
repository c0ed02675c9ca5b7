#pragma once
#include <array>
#include <vector>

#include "cloth/cloth.hpp"

namespace washtub {

/// Points on the cloth through which it meets the water, finer than the nodes where the delta
/// function is narrower than the node spacing: each node interval is cut into `refine` parts, and a
/// marker lies bilinearly between its (up to four) nodes. A closed sheet has markers across its
/// seam too, on the far side of its last nodes, which may be outside the box.
///
/// A node moves with the mean of the markers around it, weighted with its hat function; a force on
/// a node is handed to the same markers with the same weights, so both are adjoint and forces add
/// up.
template <int D>
class Markers {
 public:
  static constexpr int corners = D == 3 ? 4 : 2;

  /// `spacing`: largest distance between markers [m].
  Markers(const Cloth<D>& cloth, double spacing);

  int count() const { return static_cast<int>(node_.size()); }
  const std::array<int, corners>& nodes(int marker) const { return node_[marker]; }
  /// Bilinear weights of the marker's position.
  const std::array<double, corners>& shape(int marker) const { return shape_[marker]; }
  /// Weights of the marker in the mean of each node; over a node's markers they add up to one.
  const std::array<double, corners>& share(int marker) const { return share_[marker]; }
  Vec<D> position(int marker, const std::vector<Vec<D>>& X) const {
    Vec<D> x = shift_[marker];
    for (int c = 0; c < corners; ++c) x += shape_[marker][c] * X[node_[marker][c]];
    return x;
  }

 private:
  std::vector<std::array<int, corners>> node_;
  std::vector<std::array<double, corners>> shape_, share_;
  std::vector<Vec<D>> shift_;  ///< of the marker's place across a seam [m]
};

}  // namespace washtub
