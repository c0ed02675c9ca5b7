#pragma once
#include <optional>

#include "cloth/cloth.hpp"
#include "grid/mesh.hpp"

namespace washtub {

/// Two parts of the cloth that are too near each other; pieces among all, from 0.
struct TooNear {
  int first, second;
  double distance;  ///< [m]; 0 where they pass through each other
};

/// The nearest two parts without a common node that are nearer than `gap` [m], or that pass through
/// each other; none where all are apart.
template <int D>
std::optional<TooNear> find_too_near(const Cloth<D>& cloth, const Mesh<D>& mesh, double gap);

}  // namespace washtub
