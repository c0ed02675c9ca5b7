#pragma once
#include <vector>

#include "case/solids.hpp"
#include "cloth/cloth.hpp"
#include "flow/flow.hpp"
#include "solid/heaviside.hpp"

namespace washtub {

/// The objects of a simulation from its case.
template <int D>
Mesh<D> build_mesh(const Case& whole);
template <int D>
SidePairs<D> build_sides(const Case& whole);
/// How solids close faces.
Heaviside build_heaviside(const Case& whole);
/// What cloth does to cloth and solids.
ContactSettings build_contact(const Case& whole);
/// All cloth at its start. `notes` gets a sentence for each piece that is not where it was put.
/// @throws InputError where it cannot be placed
template <int D>
Cloth<D> build_cloth(const Case& whole, std::vector<std::string>* notes = nullptr);

/// Tries whether the grid suits the solver and the cloth has room; returns those notes.
/// @throws InputError if not
std::vector<std::string> check_build(const Case& whole);

}  // namespace washtub
