#pragma once
#include "cloth/sheet.hpp"

namespace washtub {

/// A one-dimensional sheet in the plane, `nodes` nodes at spacing `ds` [m]:
///   W = sum K_e ds E^2/2 + sum K_b |X_{i-1} - 2 X_i + X_{i+1}|^2/(2 ds^3),
///   E = (|X_{i+1} - X_i|^2/ds^2 - 1)/2.
/// Free ends carry no moment by themselves. Shear, torsion and Poisson's ratio are not used.
/// @throws InputError if there are fewer than 3 nodes or a constant is out of range
Sheet<2> make_thread(int nodes, double ds, const Material& material);

}  // namespace washtub
