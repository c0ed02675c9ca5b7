#pragma once
#include <cstdint>
#include <vector>

#include "case/case.hpp"

namespace washtub {

/// A piece of cloth as it lies before it is placed: folded or crumpled.
struct Packet {
  std::vector<Vec<3>> nodes;     ///< from the centre, along r, s and the normal [m]
  std::array<double, 2> size{};  ///< extents along r and s [m]; in 2-D the second one is 0
  double thickness = 0;          ///< extent along the normal [m]
};

bool is_packed(const ClothCase& cloth);

/// Folded to and fro at rows of nodes, first along r and then, as a whole, along s, with its layers
/// as far from each other as the gap of the contact takes at the folds. Distances along r and s are
/// those at rest, but for what the inner layers of the second fold give way to the outer ones.
///
/// Crumpled by bending about one direction at random, without stretching.
///
/// @param draw  tells crumpled pieces of a group apart
/// @throws InputError where the nodes are too far apart for that
Packet make_packet(const ClothCase& cloth, const Case& whole, std::uint64_t draw);

}  // namespace washtub
