#pragma once
#include <span>

#include "cloth/sheet.hpp"

namespace washtub {

/// A one-dimensional sheet in the plane, `nodes` nodes at spacing `ds` [m]:
///   W = sum K_e ds E^2/2 + sum K_b |X_{i-1} - 2 X_i + X_{i+1}|^2/(2 ds^3),
///   E = (|X_{i+1} - X_i|^2/ds^2 - 1)/2.
/// Free ends carry no moment by themselves. Shear, torsion and Poisson's ratio are not used. If
/// `closed`, the first node comes again after the last, moved by `period` [m] (0: a ring), and
/// there are as many edges and bends as nodes.
/// @throws InputError if there are fewer than 3 nodes or a constant is out of range
Sheet<2> make_thread(int nodes, double ds, const Material& material, bool closed = false,
                     const Vec<2>& period = Vec<2>::Zero());

/// Area within a closed line of points [m^2], positive if they go round anticlockwise.
double enclosed_area(std::span<const Vec<2>> ring);

}  // namespace washtub
