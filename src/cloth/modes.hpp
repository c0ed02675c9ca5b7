#pragma once
#include <vector>

#include "cloth/sheet.hpp"

namespace washtub {

/// Frequencies [Hz] of the lowest `count` transverse vibrations, ascending, of the flat sheet at
/// its rest length in vacuo, where only bending and torsion act; motions without energy (rigid
/// ones, twist where K_t = 0) are left out, and fewer are returned if there are fewer. A closed
/// direction is one of a sheet that goes on periodically. Masses are lumped: `areal_mass` [kg/m^2]
/// times each node's area. Exact for the discrete sheet; dense, so meant for up to some 2000 nodes
/// of a plate, 800 of a thread.
/// @param pinned  nodes that do not move
/// @throws InputError if areal_mass is not > 0, or a direction is closed without a period, since a
///         ring or tube is not flat
template <int D>
std::vector<double> natural_frequencies(const Sheet<D>& sheet, const std::vector<int>& pinned,
                                        double areal_mass, int count);

}  // namespace washtub
