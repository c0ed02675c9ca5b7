#include "washer/build.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "base/error.hpp"
#include "cloth/plate.hpp"
#include "cloth/thread.hpp"
#include "contact/start_check.hpp"
#include "contact/untangle.hpp"
#include "washer/packet.hpp"
#include "washer/placement.hpp"

namespace washtub {

template <int D>
Mesh<D> build_mesh(const Case& whole) {
  Mesh<D> mesh;
  for (int d = 0; d < D; ++d) {
    mesh.lower[d] = whole.domain.lower[d];
    mesh.cells[d] = whole.domain.cells[d];
    mesh.h[d] = whole.domain.size[d] / whole.domain.cells[d];
    mesh.periodic[d] = whole.domain.sides[2 * d].kind == SideKind::periodic;
  }
  return mesh;
}

namespace {

template <int D>
typename Side<D>::Kind side_kind(SideKind kind) {
  using Kind = typename Side<D>::Kind;
  switch (kind) {
    case SideKind::slip:
      return Kind::slip;
    case SideKind::periodic:
      return Kind::periodic;
    case SideKind::inflow:
      return Kind::inflow;
    case SideKind::outflow:
      return Kind::outflow;
    case SideKind::far_field:
      return Kind::far_field;
    case SideKind::no_slip:
    case SideKind::moving_wall:
      break;
  }
  return Kind::wall;
}

}  // namespace

template <int D>
SidePairs<D> build_sides(const Case& whole) {
  SidePairs<D> sides;
  for (int d = 0; d < D; ++d)
    for (int s = 0; s < 2; ++s) {
      const auto& side = whole.domain.sides[2 * d + s];
      sides[d][s] = {side_kind<D>(side.kind), side.velocity.template head<D>()};
    }
  return sides;
}

Heaviside build_heaviside(const Case& whole) {
  const auto& domain = whole.domain;
  switch (domain.mapping) {
    case Mapping::smooth:
      return Heaviside::smooth(domain.mapping_width * domain.size[0] / domain.cells[0]);
    case Mapping::gradual:
      return Heaviside::gradual();
    default:
      return Heaviside::sharp(domain.mapping_shift);
  }
}

ContactSettings build_contact(const Case& whole) {
  const ContactCase given = complete_contact(whole);
  ContactSettings contact;
  contact.scheme = given.scheme;
  if (given.scheme == ContactScheme::none) return contact;
  double finest = std::numeric_limits<double>::infinity();
  for (int d = 0; d < whole.dimension; ++d)
    finest = std::min(finest, whole.domain.size[d] / whole.domain.cells[d]);
  contact.range = given.range;
  contact.pressure = given.pressure;
  // Layers that start much nearer to each other than the range part slowly.
  const bool packed = std::any_of(whole.cloth.begin(), whole.cloth.end(), is_packed);
  contact.rise = (packed ? 1 : 0.1) * whole.scale.period;
  contact.gap = given.gap;
  contact.areal_mass = whole.fluid.density * finest * kernel_thickness(whole.coupling.kernel);
  for (const ClothCase& cloth : whole.cloth)
    contact.permeability = std::max(contact.permeability, cloth.material.permeability);
  contact.solid_time = given.solid_time;
  return contact;
}

namespace {

/// Nodes of a piece that do not move.
std::vector<int> held_nodes(const ClothCase& cloth, std::array<int, 2> nodes) {
  std::vector<int> held;
  const auto is_in = [&](int d, int i) {
    for (int end = 0; end < 2; ++end) {
      const int from_end = end == 0 ? i : nodes[static_cast<std::size_t>(d)] - 1 - i;
      if ((is_held(cloth.pinned, d, end) && from_end < 1) ||
          (is_held(cloth.clamped, d, end) && from_end < 2))
        return true;
    }
    return false;
  };
  for (int j = 0; j < nodes[1]; ++j)
    for (int i = 0; i < nodes[0]; ++i)
      if (is_in(0, i) || is_in(1, j)) held.push_back(i + nodes[0] * j);
  return held;
}

/// The rest state of a group's pieces; closed ones repeat with the length at which they are placed.
template <int D>
Sheet<D> build_sheet(const ClothCase& cloth, const Case& whole, const Patch& patch) {
  const auto nodes = cloth_nodes(cloth, whole);
  const auto spacing = cloth_spacing(cloth, whole);
  std::array<Vec<D>, 2> period;
  for (std::size_t d = 0; d < 2; ++d)
    period[d] = cloth.closed[d] ? Vec<D>(patch.size[d] * patch.along[d].template head<D>())
                                : Vec<D>(Vec<D>::Zero());
  if constexpr (D == 3)
    return make_plate(nodes, spacing, cloth.material, cloth.closed, period);
  else
    return make_thread(nodes[0], spacing[0], cloth.material,
                       cloth.closed[0] || cloth.arrangement == Arrangement::ring, period[0]);
}

}  // namespace

namespace {

/// Moves pieces apart that start too near to each other. A piece may go where its nodes are half a
/// cell away from all sides and solids.
template <int D>
void part_pieces(Cloth<D>& cloth, const Case& whole, std::vector<std::string>* notes) {
  const ContactSettings contact = build_contact(whole);
  const Mesh<D> mesh = build_mesh<D>(whole);
  const auto solids = build_solids(whole, 0);
  const std::vector<Vec<D>> start = cloth.position;
  const Vec<D> least = 0.5 * mesh.h;
  const auto is_free = [&](const Vec<D>& x) {
    for (int d = 0; d < D; ++d)
      if (!mesh.periodic[d] &&
          std::min(x[d] - mesh.lower[d], mesh.lower[d] + mesh.size()[d] - x[d]) < least[d])
        return false;
    Vec<3> place = Vec<3>::Zero();
    place.template head<D>() = x;
    return std::none_of(solids.begin(), solids.end(), [&](const Solid& solid) {
      return solid.psi(place, 0) > -least.maxCoeff();
    });
  };
  untangle<D>(cloth, mesh, contact.gap, [&](int piece, const Vec<D>& way) {
    for (const auto& group : cloth.groups) {
      const int p = piece - group.first_piece;
      if (p >= group.pieces) continue;
      for (int n = 0; n < group.sheet.nodes(); ++n)
        if (!is_free(start[static_cast<std::size_t>(group.node(p, n))] + way)) return false;
      return true;
    }
    return false;
  });
  if (!notes) return;
  for (const auto& group : cloth.groups)
    for (int p = 0; p < group.pieces; ++p) {
      const auto node = static_cast<std::size_t>(group.node(p, 0));
      if (const double way = (cloth.position[node] - start[node]).norm(); way > 0)
        notes->push_back(
            fmt::format("piece {} starts {:.3g} cm from where it was put "
                        "(contact.untangle)",
                        group.first_piece + p + 1, 100 * way));
    }
}

/// Cloth that starts tangled stays tangled, since nothing passes through cloth.
/// @throws InputError
template <int D>
void refuse_tangled(const Cloth<D>& cloth, const Case& whole) {
  const ContactSettings contact = build_contact(whole);
  if (contact.scheme == ContactScheme::none) return;
  const auto found = find_too_near(cloth, build_mesh<D>(whole), contact.gap);
  if (!found) return;
  const std::string who =
      found->first == found->second
          ? fmt::format("piece {} starts", found->first + 1)
          : fmt::format("pieces {} and {} start", found->first + 1, found->second + 1);
  const std::string how =
      found->distance > 0
          ? fmt::format("{} {:.3g} mm from {}, allowed: at least {:.3g} mm (contact.gap)", who,
                        1e3 * found->distance,
                        found->first == found->second ? "itself" : "each other", 1e3 * contact.gap)
          : fmt::format("{} by passing through {}", who,
                        found->first == found->second ? "itself" : "each other");
  throw InputError(fmt::format(
      "cloth: {}; try another start of the cloth, such as a larger "
      "cloth.clearance or fewer pieces, {}",
      how,
      whole.contact.untangle
          ? "since contact.untangle finds no place for them that pins, solids and sides "
            "let them go to"
          : "contact.untangle = true, or contact.scheme = \"none\""));
}

}  // namespace

template <int D>
Cloth<D> build_cloth(const Case& whole, std::vector<std::string>* notes) {
  Cloth<D> cloth;
  std::vector<Patch> placed;
  for (const auto& group : whole.cloth) {
    if (group.count == 0) continue;
    const auto patches = place_cloth(group, whole, placed);
    placed.insert(placed.end(), patches.begin(), patches.end());
    std::vector<Vec<D>> where;
    for (const Patch& patch : patches)
      for (const Vec<3>& x : node_places(patch, group, whole))
        where.push_back(x.template head<D>());
    cloth.add(build_sheet<D>(group, whole, patches.front()), where,
              held_nodes(group, cloth_nodes(group, whole)));
  }
  if (whole.contact.untangle && whole.contact.scheme != ContactScheme::none)
    part_pieces(cloth, whole, notes);
  refuse_tangled(cloth, whole);
  return cloth;
}

namespace {

template <int D>
std::vector<std::string> check(const Case& whole) {
  std::vector<std::string> notes;
  granularity(build_mesh<D>(whole));
  build_cloth<D>(whole, &notes);
  return notes;
}

}  // namespace

std::vector<std::string> check_build(const Case& whole) {
  return whole.dimension == 2 ? check<2>(whole) : check<3>(whole);
}

template Mesh<2> build_mesh<2>(const Case&);
template Mesh<3> build_mesh<3>(const Case&);
template SidePairs<2> build_sides<2>(const Case&);
template SidePairs<3> build_sides<3>(const Case&);
template Cloth<2> build_cloth<2>(const Case&, std::vector<std::string>*);
template Cloth<3> build_cloth<3>(const Case&, std::vector<std::string>*);

}  // namespace washtub
