#pragma once
#include "cloth/sheet.hpp"

namespace washtub {

/// A two-dimensional sheet in space, nodes[0] x nodes[1] nodes at spacings ds_r, ds_s [m]. Its
/// energy discretises
///   W = int K_e (E_ss^2 + 2 nu E_ss E_rr + E_rr^2)/2 + K_s E_sr^2
///         + K_b (|X_ss|^2 + 2 nu X_ss . X_rr + |X_rr|^2)/2 + K_t |X_sr|^2  dr ds,
/// which is that of App. A for small strain (E_ss = (|X_s|^2 - 1)/2, E_sr = X_s . X_r/2):
/// E_ss and E_rr on edges, E_sr and X_sr on quads, curvatures on nodes, each times its area, halved
/// on the border. A curvature across a border is not a degree of freedom: it takes the value of
/// least energy, which is the moment-free edge X_ss = -nu X_rr. Along a closed direction there is
/// no border: the first row of nodes comes again after the last, moved by `period` [m] (0: a tube).
/// @throws InputError if there are fewer than 3 x 3 nodes or a constant is out of range
Sheet<3> make_plate(std::array<int, 2> nodes, std::array<double, 2> spacing,
                    const Material& material, std::array<bool, 2> closed = {},
                    const std::array<Vec<3>, 2>& period = {Vec<3>::Zero(), Vec<3>::Zero()});

}  // namespace washtub
