#pragma once
#include <span>
#include <vector>

#include "base/archive.hpp"
#include "cloth/sheet.hpp"

namespace washtub {

/// A number of equal pieces of cloth; their nodes stand one piece after the other.
template <int D>
struct ClothGroup {
  Sheet<D> sheet;
  int pieces = 0;
  int first_node = 0;         ///< in the arrays of Cloth
  int first_piece = 0;        ///< among all pieces
  std::vector<int> pinned{};  ///< nodes of every piece that never move

  int nodes() const { return sheet.nodes() * pieces; }
  int node(int piece, int local) const { return first_node + piece * sheet.nodes() + local; }
};

/// All cloth of a simulation: what it is made of and where it is. Every rank knows all of it.
template <int D>
struct Cloth {
  std::vector<ClothGroup<D>> groups;
  std::vector<Vec<D>> position;         ///< X [m]
  std::vector<Vec<D>> velocity;         ///< V = dX/dt over the last step [m/s]
  std::vector<Vec<D>> velocity_before;  ///< over the step before [m/s]
  std::vector<Vec<D>> elastic;          ///< -dW/dX of the last step [N]

  /// Adds a group whose pieces stand at `where` (pieces x nodes), each held at its nodes `pinned`.
  void add(const Sheet<D>& sheet, std::span<const Vec<D>> where,
           const std::vector<int>& pinned = {}) {
    const int count = static_cast<int>(where.size()) / sheet.nodes();
    groups.push_back({sheet, count, nodes(), pieces(), pinned});
    position.insert(position.end(), where.begin(), where.end());
    for (auto* v : {&velocity, &velocity_before, &elastic})
      v->resize(position.size(), Vec<D>::Zero());
  }
  void state(Archive& archive) {
    archive.same_length("position", position);
    archive.same_length("velocity", velocity);
    archive.same_length("velocity before", velocity_before);
  }
  int nodes() const { return static_cast<int>(position.size()); }
  int pieces() const {
    return groups.empty() ? 0 : groups.back().first_piece + groups.back().pieces;
  }
  std::span<const Vec<D>> piece(const ClothGroup<D>& g, int p) const {
    return std::span(position).subspan(static_cast<std::size_t>(g.node(p, 0)),
                                       static_cast<std::size_t>(g.sheet.nodes()));
  }
};

/// Mass of each node beyond that of the water it displaces [kg].
template <int D>
std::vector<double> excess_masses(const Cloth<D>& cloth) {
  std::vector<double> mass;
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p)
      for (const double area : g.sheet.area) mass.push_back(g.sheet.material.excess_mass * area);
  return mass;
}

}  // namespace washtub
