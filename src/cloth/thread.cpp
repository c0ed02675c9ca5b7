#include "cloth/thread.hpp"

#include "base/error.hpp"

namespace washtub {

Sheet<2> make_thread(int nodes, double ds, const Material& material) {
  if (nodes < 3) throw InputError("a thread needs at least 3 nodes to bend; try more nodes");
  if (ds <= 0 || material.stretch <= 0 || material.bending < 0)
    throw InputError("a thread needs spacing > 0, stretch stiffness > 0, bending stiffness >= 0");
  Sheet<2> sheet;
  sheet.extent = {1, nodes};
  sheet.spacing = {0, ds};
  sheet.material = material;
  sheet.area.assign(nodes, ds);
  sheet.area.front() = sheet.area.back() = ds / 2;
  for (int i = 0; i + 1 < nodes; ++i)
    sheet.edges.push_back({{{{i, i + 1}}}, {0.5 / (ds * ds)}, -0.5, material.stretch * ds});
  const double w = 1 / (ds * ds);
  for (int i = 1; i + 1 < nodes; ++i)
    sheet.bends.push_back({3, {i - 1, i, i + 1}, {w, -2 * w, w}, material.bending * ds});
  return sheet;
}

}  // namespace washtub
