#pragma once
#include <cstdint>
#include <vector>

#include "cloth/cloth.hpp"

namespace washtub::testing {

/// Loose nodes: pieces of one node each, so that every node is its own only marker.
template <int D>
Cloth<D> dots(const std::vector<Vec<D>>& where) {
  Sheet<D> sheet;
  sheet.extent = {1, 1};
  sheet.area = {1};
  Cloth<D> cloth;
  cloth.add(sheet, where);
  return cloth;
}

/// Numbers between -1 and 1 that depend only on `seed`.
inline double scatter(std::uint64_t seed) {
  seed = (seed + 0x9e3779b97f4a7c15U) * 0xbf58476d1ce4e5b9U;
  seed = (seed ^ (seed >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((seed ^ (seed >> 31U)) >> 11U) * 0x1p-52 - 1;
}

}  // namespace washtub::testing
