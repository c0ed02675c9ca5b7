#include "washer/build.hpp"

#include "base/error.hpp"
#include "cloth/plate.hpp"
#include "cloth/thread.hpp"
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

template <int D>
std::array<std::array<Side<D>, 2>, D> build_sides(const Case& whole) {
  std::array<std::array<Side<D>, 2>, D> sides;
  using Kind = typename Side<D>::Kind;
  for (int d = 0; d < D; ++d)
    for (int s = 0; s < 2; ++s) {
      const auto& side = whole.domain.sides[2 * d + s];
      sides[d][s].kind = side.kind == SideKind::slip       ? Kind::slip
                         : side.kind == SideKind::periodic ? Kind::periodic
                                                           : Kind::wall;
      if (side.kind == SideKind::moving_wall)
        sides[d][s].velocity = side.velocity.template head<D>();
    }
  return sides;
}

template <int D>
typename ImmersedBoundary<D>::Reflections build_reflections(const Case& whole) {
  typename ImmersedBoundary<D>::Reflections reflections;
  for (int d = 0; d < D; ++d)
    for (int s = 0; s < 2; ++s) {
      const auto kind = whole.domain.sides[2 * d + s].kind;
      reflections[d][s] = kind == SideKind::periodic ? Reflection::none
                          : kind == SideKind::slip   ? Reflection::even
                                                     : Reflection::odd;
    }
  return reflections;
}

std::vector<Solid> build_solids(const Case& whole) {
  std::vector<Solid> solids;
  for (const auto& s : whole.solids) solids.push_back({s.name, s.shape, s.centre, s.drive});
  return solids;
}

double smooth_width(const Case& whole) {
  if (whole.domain.mapping == Mapping::sharp) return 0;
  return whole.domain.mapping_width * whole.domain.size[0] / whole.domain.cells[0];
}

template <int D>
Cloth<D> build_cloth(const Case& whole) {
  Cloth<D> cloth;
  for (const auto& group : whole.cloth) {
    if (group.count == 0) continue;
    for (const auto& side : whole.domain.sides)
      if (side.kind == SideKind::moving_wall)
        throw InputError(
            "domain.sides: cloth beside a moving wall is not supported; let a solid "
            "move instead, or take the cloth out");
    const auto nodes = cloth_nodes(group, whole);
    const auto where = place_cloth<D>(group, nodes, whole, cloth);
    std::array<double, 2> spacing{};
    for (int d = 0; d < 2; ++d)
      if (nodes[d] > 1) spacing[d] = group.size[d] / (nodes[d] - 1);
    if constexpr (D == 3)
      cloth.add(make_plate(nodes, spacing, group.material), where);
    else
      cloth.add(make_thread(nodes[0], spacing[0], group.material), where);
  }
  return cloth;
}

namespace {

template <int D>
void check(const Case& whole) {
  granularity(build_mesh<D>(whole));
  build_cloth<D>(whole);
}

}  // namespace

void check_build(const Case& whole) {
  if (whole.dimension == 2)
    check<2>(whole);
  else
    check<3>(whole);
}

template Mesh<2> build_mesh<2>(const Case&);
template Mesh<3> build_mesh<3>(const Case&);
template std::array<std::array<Side<2>, 2>, 2> build_sides<2>(const Case&);
template std::array<std::array<Side<3>, 2>, 3> build_sides<3>(const Case&);
template ImmersedBoundary<2>::Reflections build_reflections<2>(const Case&);
template ImmersedBoundary<3>::Reflections build_reflections<3>(const Case&);
template Cloth<2> build_cloth<2>(const Case&);
template Cloth<3> build_cloth<3>(const Case&);

}  // namespace washtub
