#pragma once
#include "flow/flow.hpp"

namespace washtub {

/// Rate at which viscosity turns the water's kinetic energy into heat [W], per metre in 2-D:
/// 2 mu S:S over the volume, with S from the differences that the viscous term takes. Cells and
/// edges between an open face and a closed one count, so that this is what the viscous term takes
/// out of the water plus what the friction of solids and sides puts in. Ghosts current; collective.
template <int D>
double dissipation(const Flow<D>& flow);

/// Power of the sides of the box on the water through friction [W]: that of moving walls. Ghosts
/// current; collective.
template <int D>
double power_of_sides(const Flow<D>& flow, const SidePairs<D>& sides);

}  // namespace washtub
