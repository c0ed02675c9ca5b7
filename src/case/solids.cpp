#include "case/solids.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

constexpr double near = 2;     // cells outside the box in which solids are felt: cloth keeps off
constexpr double longest = 4;  // lengths of the box, above which a solid is taken as endless

/// How far matter reaches from the axis along x, y and z, at any angle that the solid takes.
Bounds extent(const SolidCase& solid) {
  Bounds b = solid.shape.bounds();
  if (!solid.drive.moving()) return b;
  const Vec<3> far = b.lower.cwiseAbs().cwiseMax(b.upper.cwiseAbs());
  const double reach = std::hypot(far.x(), far.y());
  b.lower.head<2>().setConstant(-reach);
  b.upper.head<2>().setConstant(reach);
  return b;
}

/// The place of the same matter in the box.
Vec<3> into_box(const Vec<3>& x, const SolidCase& solid, const Case& whole) {
  const DomainCase& box = whole.domain;
  Vec<3> in = x;
  for (int axis = 0; axis < whole.dimension; ++axis)
    if (has_images(solid, whole, axis)) {
      const double along = std::fmod(x[axis] - box.lower[axis], box.size[axis]);
      in[axis] = box.lower[axis] + along + (along < 0 ? box.size[axis] : 0);
    }
  return in;
}

struct Range {
  int first = 0, last = 0;
};

/// Shifts along an axis, in lengths of the box, that bring a solid at `centre` to the box, or
/// nearer to it than `margin` or its length.
Range shifts(const SolidCase& solid, const Vec<3>& centre, const Case& whole, int axis,
             double margin) {
  if (axis >= whole.dimension || !has_images(solid, whole, axis)) return {};
  const Bounds own = extent(solid);
  const double lower = whole.domain.lower[axis], length = whole.domain.size[axis];
  margin = std::min(margin, length);
  const double first = (lower - margin - centre[axis] - own.upper[axis]) / length;
  const double last = (lower + length + margin - centre[axis] - own.lower[axis]) / length;
  return {static_cast<int>(std::ceil(first)), static_cast<int>(std::floor(last))};
}

void add_images(std::vector<Solid>& solids, std::size_t body, const Case& whole, double margin) {
  const SolidCase& solid = whole.solids[body];
  const Solid first = solids[body];
  std::array<Range, 3> range;
  for (int axis = 0; axis < 3; ++axis)
    range[static_cast<std::size_t>(axis)] = shifts(solid, first.centre, whole, axis, margin);
  for (int k = range[2].first; k <= range[2].last; ++k)
    for (int j = range[1].first; j <= range[1].last; ++j)
      for (int i = range[0].first; i <= range[0].last; ++i) {
        if (i == 0 && j == 0 && k == 0) continue;
        solids.push_back(first);
        solids.back().centre += whole.domain.size.cwiseProduct(Vec<3>(i, j, k));
      }
}

}  // namespace

bool has_images(const SolidCase& solid, const Case& whole, int axis) {
  if (whole.domain.sides[2 * static_cast<std::size_t>(axis)].kind != SideKind::periodic)
    return false;
  const Bounds own = extent(solid);
  return own.upper[axis] - own.lower[axis] <= longest * whole.domain.size[axis];
}

std::vector<Solid> build_solids(const Case& whole, double margin) {
  std::vector<Solid> solids;
  for (const SolidCase& s : whole.solids)
    solids.push_back({s.name, s.shape, into_box(s.centre, s, whole), s.drive, solids.size()});
  for (std::size_t body = 0; body < whole.solids.size(); ++body)
    add_images(solids, body, whole, margin);
  return solids;
}

std::vector<Solid> build_solids(const Case& whole) {
  double cell = 0;
  for (int axis = 0; axis < whole.dimension; ++axis)
    cell = std::max(cell,
                    whole.domain.size[axis] / whole.domain.cells[static_cast<std::size_t>(axis)]);
  const DomainCase& domain = whole.domain;
  const double layer = domain.mapping == Mapping::smooth    ? domain.mapping_width
                       : domain.mapping == Mapping::gradual ? 1
                                                            : 0;
  return build_solids(whole, (near + layer) * cell);
}

}  // namespace washtub
