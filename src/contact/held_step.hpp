#pragma once
#include <vector>

#include "base/vec.hpp"

namespace washtub {

/// The implicit step of the cloth under way, as far as it concerns what keeps nodes off others:
/// each node goes where its inertia, its own piece and the forces below let it.
template <int D>
struct HeldStep {
  using Nodes = std::vector<Vec<D>>;

  double dt;                         ///< [s]
  const Nodes& start;                ///< X^n [m]
  const Nodes& next;                 ///< as solved last [m]
  const std::vector<Mat<D>>& yield;  ///< way of each node by a force, if nothing holds it [m/N]
  Nodes& push;                       ///< forces that keep parts of the cloth apart [N]
  std::vector<char>& pushed;  ///< nodes whose `push` or hold has changed since they were solved
};

}  // namespace washtub
