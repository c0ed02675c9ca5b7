#pragma once
#include <array>
#include <optional>

#include "base/vec.hpp"

namespace washtub {

/// Two parts of the cloth that may touch: a node and a face, or (in space) two edges.
template <int D>
struct Pair {
  static constexpr std::size_t points = D + 1;
  using Places = std::array<Vec<D>, points>;
  using Weights = std::array<double, points>;

  std::array<int, points> point;  ///< of the surface; the first part before the second
  int split = 1;                  ///< points of the first part: 1 or, for two edges, 2
  Vec<D> shift = Vec<D>::Zero();  ///< of the first part to its image near the second [m]

  auto operator<=>(const Pair& other) const { return point <=> other.point; }
  bool operator==(const Pair& other) const { return point == other.point && split == other.split; }

  /// Places of its points, the first part moved by `shift`.
  Places places(const std::vector<Vec<D>>& x) const {
    Places p;
    for (std::size_t k = 0; k < points; ++k) {
      p[k] = x[static_cast<std::size_t>(point[k])];
      if (static_cast<int>(k) < split) p[k] += shift;
    }
    return p;
  }
};

/// Where two parts are nearest: gap = sum of weight times place leads from the second to the first.
template <int D>
struct Nearness {
  typename Pair<D>::Weights weight;
  Vec<D> gap;  ///< [m]
};

template <int D>
Nearness<D> nearest(int split, const typename Pair<D>::Places& x);

/// The time in (0, 1] at which two parts that move by `way` come within `least` of each other.
template <int D>
struct Impact {
  double time;
  typename Pair<D>::Weights weight;
  Vec<D> normal;  ///< unit vector from the second part to the first; 0 where they touch
};

/// Found by conservative advancement: never late, and early by no more than makes the distance 1 %
/// larger than `least`. None if they stay farther apart all the way. The common motion of the
/// points does not matter.
template <int D>
std::optional<Impact<D>> find_impact(int split, const typename Pair<D>::Places& x,
                                     typename Pair<D>::Places way, double least);

/// By how much the distance of the parts can shrink on their way [m].
template <int D>
double closing(int split, const typename Pair<D>::Places& way);

}  // namespace washtub
