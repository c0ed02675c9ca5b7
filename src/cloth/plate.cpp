#include "cloth/plate.hpp"

#include "base/error.hpp"

namespace washtub {
namespace {

void check(std::array<int, 2> nodes, std::array<double, 2> spacing, const Material& m) {
  if (nodes[0] < 3 || nodes[1] < 3)
    throw InputError("a plate needs at least 3 x 3 nodes to bend; try more nodes");
  if (spacing[0] <= 0 || spacing[1] <= 0 || m.stretch <= 0)
    throw InputError("a plate needs spacings > 0 and stretch stiffness > 0");
  if (m.shear < 0 || m.bending < 0 || m.torsion < 0)
    throw InputError("a plate needs shear, bending and torsion stiffness >= 0");
  if (m.poisson < 0 || m.poisson >= 1)
    throw InputError("a plate needs Poisson's ratio from 0 to below 1");
}

bool inside(int i, int n) { return i > 0 && i < n - 1; }

void add_areas(Sheet<3>& sheet) {
  const auto [nr, ns] = sheet.extent;
  for (int j = 0; j < ns; ++j) {
    for (int i = 0; i < nr; ++i) {
      const double share = (inside(i, nr) ? 1 : 0.5) * (inside(j, ns) ? 1 : 0.5);
      sheet.area.push_back(share * sheet.spacing[0] * sheet.spacing[1]);
    }
  }
}

void add_edges(Sheet<3>& sheet) {
  const auto [nr, ns] = sheet.extent;
  const auto [dr, ds] = sheet.spacing;
  const double stiffness = sheet.material.stretch * (1 - sheet.material.poisson) * dr * ds;
  const auto edge = [&](int a, int b, double length, bool whole) {
    const double share = whole ? 1 : 0.5;
    sheet.edges.push_back({{{{a, b}}}, {0.5 / (length * length)}, -0.5, share * stiffness});
  };
  for (int j = 0; j < ns; ++j) {
    for (int i = 0; i < nr; ++i) {
      const int x = sheet.node(i, j);
      if (i + 1 < nr) edge(x, sheet.node(i + 1, j), dr, inside(j, ns));
      if (j + 1 < ns) edge(x, sheet.node(i, j + 1), ds, inside(i, nr));
    }
  }
}

/// Shear E_sr = (|X_3 - X_0|^2 - |X_2 - X_1|^2)/(8 area), twist and dilation of each quad.
void add_quads(Sheet<3>& sheet) {
  const auto [dr, ds] = sheet.spacing;
  const double a = dr * ds, wr = 0.25 / (dr * dr), ws = 0.25 / (ds * ds);
  const Material& m = sheet.material;
  for (int j = 0; j + 1 < sheet.extent[1]; ++j) {
    for (int i = 0; i + 1 < sheet.extent[0]; ++i) {
      const int x0 = sheet.node(i, j), x1 = x0 + 1, x2 = sheet.node(i, j + 1), x3 = x2 + 1;
      sheet.shears.push_back({{{{x0, x3}, {x1, x2}}}, {0.125 / a, -0.125 / a}, 0, 2 * m.shear * a});
      sheet.bends.push_back(
          {4, {x0, x1, x2, x3}, {1 / a, -1 / a, -1 / a, 1 / a}, 2 * m.torsion * a});
      if (m.poisson > 0)
        sheet.dilations.push_back({{{{x0, x1}, {x2, x3}, {x0, x2}, {x1, x3}}},
                                   {wr, wr, ws, ws},
                                   -1,
                                   m.stretch * m.poisson * a});
    }
  }
}

/// Curvatures at nodes. Inside, |p|^2 + 2 nu p.q + |q|^2 = (1 - nu)(|p|^2 + |q|^2) + nu |p + q|^2;
/// on a border its least value over the missing one, (1 - nu^2)|p|^2.
void add_curvatures(Sheet<3>& sheet) {
  const auto [nr, ns] = sheet.extent;
  const double wr = 1 / (sheet.spacing[0] * sheet.spacing[0]);
  const double ws = 1 / (sheet.spacing[1] * sheet.spacing[1]);
  const double nu = sheet.material.poisson;
  for (int j = 0; j < ns; ++j) {
    for (int i = 0; i < nr; ++i) {
      const int x = sheet.node(i, j);
      const bool along_r = inside(i, nr), along_s = inside(j, ns);
      const double stiffness = sheet.material.bending * sheet.area[x];
      const double own = stiffness * (along_r && along_s ? 1 - nu : 1 - nu * nu);
      if (along_r) sheet.bends.push_back({3, {x - 1, x, x + 1}, {wr, -2 * wr, wr}, own});
      if (along_s) sheet.bends.push_back({3, {x - nr, x, x + nr}, {ws, -2 * ws, ws}, own});
      if (along_r && along_s && nu > 0)
        sheet.bends.push_back({5,
                               {x - 1, x + 1, x, x - nr, x + nr},
                               {wr, wr, -2 * (wr + ws), ws, ws},
                               stiffness * nu});
    }
  }
}

}  // namespace

Sheet<3> make_plate(std::array<int, 2> nodes, std::array<double, 2> spacing,
                    const Material& material) {
  check(nodes, spacing, material);
  Sheet<3> sheet;
  sheet.extent = nodes;
  sheet.spacing = spacing;
  sheet.material = material;
  add_areas(sheet);
  add_edges(sheet);
  add_quads(sheet);
  add_curvatures(sheet);
  return sheet;
}

}  // namespace washtub
