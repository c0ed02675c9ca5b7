#pragma once
#include <span>
#include <vector>

#include "washer/patch.hpp"

namespace washtub {

/// Where a group of cloth stands at t = 0, piece by piece.
///
/// book    flat pages in vertical planes through the z axis, radial from `inner_radius`, upwards
///         from `bottom` above the floor, equally spaced in angle by their number among all pieces
///         of the case; each is shifted (normal, `shift` per coordinate) and turned about its
///         centre (normal, `tilt` about each of its own three axes)
/// random  anywhere in the box, in any direction, bent to an arc of `curvature`
/// layers  upright and bent about the z axis, layer within layer from the wall of the tub inwards,
///         as many round and above each other as there is room for
/// sheet   one piece from `origin` along two directions, bent and rippled
/// ring    one closed thread about `centre`
///
/// Pieces of the first three may be folded or crumpled (packet.hpp).
///
/// Pages, random pieces and those in layers are drawn again until they are at least `clearance`
/// from every solid, every side of the box and every piece before them; where one finds no place,
/// its group starts again with other draws. The draws come from std::mt19937_64(seed), uniform
/// numbers from its upper 53 bits and normal ones from those by Box and Muller, so that a seed
/// gives the same start everywhere and on every grid, but for layers and packets, whose distances
/// follow the cells. Sheets and rings must not touch solids,
/// except with the nodes that are held, nor other pieces, nor leave the box but through periodic
/// sides.
///
/// @param others  pieces that stand already
/// @throws InputError naming the piece and what it hits if it has no place
std::vector<Patch> place_cloth(const ClothCase& cloth, const Case& whole,
                               std::span<const Patch> others);

/// Nodes of a piece [m], node (i, j) at place i + nodes[0] j, unstretched unless it is closed or
/// rippled.
std::vector<Vec<3>> node_places(const Patch& patch, const ClothCase& cloth, const Case& whole);

}  // namespace washtub
