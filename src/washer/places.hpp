#pragma once
#include <string>

#include "cloth/cloth.hpp"
#include "flow/flow.hpp"

namespace washtub {

/// "at (0.1, 0.25, 0.02) m": where a velocity component is largest. Collective.
template <int D>
std::string place_of_largest_speed(const Flow<D>& flow);

/// The first thing that is not a number: "the cloth, at node (3, 4) of piece 7", "the velocity, at
/// (0.1, 0.25, 0.02) m" or "the pressure, at ..."; empty where all is finite. Collective.
template <int D>
std::string not_finite(const Flow<D>& flow, const Cloth<D>& cloth);

}  // namespace washtub
