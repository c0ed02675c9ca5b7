#pragma once
#include "solid/mapping.hpp"

namespace washtub {

/// Largest speed that the surface of a solid reaches in the course of its drive [m/s]: the peak of
/// its angular speed times the largest distance from its axis at which a face that it closes has an
/// open one beside it; 0 where none turns. Collective.
template <int D>
double fastest_surface(const Grid<D>& grid, const DomainMapping<D>& mapping);

}  // namespace washtub
