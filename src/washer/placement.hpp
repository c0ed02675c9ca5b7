#pragma once
#include <vector>

#include "cloth/cloth.hpp"
#include "washer/case.hpp"

namespace washtub {

/// Where a group of cloth stands at t = 0: its pieces one after the other, each flat and
/// unstretched, node (i, j) of a piece at place i + nodes[0] j.
///
/// book    pages in vertical planes through the z axis, radial from `inner_radius`, upwards from
///         `bottom` above the floor, equally spaced in angle by their number among all pieces of
///         the case; each is shifted (normal, `shift` per coordinate) and turned about its centre
///         (normal, `tilt` about each of its own three axes)
/// random  anywhere in the box, in any direction
/// sheet   one piece from `origin` along two directions
///
/// Pages and random pieces are drawn again until they are at least `clearance` from every solid,
/// every side of the box and every piece before them; where one finds no place, its group starts
/// again with other draws. The draws come from std::mt19937_64(seed),
/// uniform numbers from its upper 53 bits and normal ones from those by Box and Muller, so that a
/// seed gives the same start everywhere.
///
/// @param nodes   of a piece, along r and s; {n, 1} in 2-D
/// @param others  groups that stand already, flat
/// @throws InputError naming the piece and what it hits if no free place is found, or a sheet
///         touches a solid or another piece or leaves the box
template <int D>
std::vector<Vec<D>> place_cloth(const ClothCase& cloth, std::array<int, 2> nodes, const Case& whole,
                                const Cloth<D>& others);

}  // namespace washtub
