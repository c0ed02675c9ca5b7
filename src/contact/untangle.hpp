#pragma once
#include <functional>

#include "cloth/cloth.hpp"
#include "grid/mesh.hpp"

namespace washtub {

/// Moves pieces, each as it is and a little at a time the shortest way, until none passes through
/// another one or is nearer to it than `gap` [m]. Pieces with pinned nodes stay, and no piece goes
/// where `allowed` does not let it be (piece, by how much it would be moved in all). False where it
/// does not find such places, or where a piece is tangled with itself; then the cloth is partly
/// moved.
template <int D>
bool untangle(Cloth<D>& cloth, const Mesh<D>& mesh, double gap,
              const std::function<bool(int, const Vec<D>&)>& allowed);

}  // namespace washtub
