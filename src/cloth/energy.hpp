#pragma once
#include "cloth/cloth.hpp"

namespace washtub {

/// What the cloth holds of energy [J], per metre in 2-D: elastic, and of the mass beyond that of
/// the displaced water the kinetic energy. The rest of its inertia is the water's.
template <int D>
double energy(const Cloth<D>& cloth);

}  // namespace washtub
