#pragma once
#include "flow/pressure/level.hpp"

namespace washtub {

/// Takes out of the right-hand side its mean over each connected region of open cells (collective),
/// so that a pressure exists that balances it.
template <int D>
void remove_component_means(const Grid<D>& grid, Problem<D>& problem);

}  // namespace washtub
