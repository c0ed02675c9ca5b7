#include "cloth/thread.hpp"

#include "base/error.hpp"
#include "cloth/join.hpp"

namespace washtub {

Sheet<2> make_thread(int nodes, double ds, const Material& material, bool closed,
                     const Vec<2>& period) {
  if (nodes < 3) throw InputError("a thread needs at least 3 nodes to bend; try more nodes");
  if (ds <= 0 || material.stretch <= 0 || material.bending < 0)
    throw InputError("a thread needs spacing > 0, stretch stiffness > 0, bending stiffness >= 0");
  Sheet<2> sheet;
  sheet.extent = {1, nodes};
  sheet.spacing = {0, ds};
  sheet.material = material;
  sheet.closed[1] = closed;
  sheet.period[1] = period;
  for (int j = 0; j < nodes; ++j) sheet.area.push_back(sheet.inside(1, j) ? ds : ds / 2);
  const double w = 1 / (ds * ds);
  for (int j = 0; j < nodes; ++j) {
    const Image<2> before = sheet.image(0, j - 1), x = sheet.image(0, j);
    const Image<2> after = sheet.image(0, j + 1);
    if (j < sheet.intervals(1))
      join_strain<1>(sheet, {{{x, after}}}, {0.5 * w}, -0.5, material.stretch * ds,
                     stiffening(material, ds));
    if (sheet.inside(1, j))
      join_bend(sheet, {{before, w}, {x, -2 * w}, {after, w}}, material.bending * ds);
  }
  return sheet;
}

double enclosed_area(std::span<const Vec<2>> ring) {
  double twice = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec<2> a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return twice / 2;
}

}  // namespace washtub
