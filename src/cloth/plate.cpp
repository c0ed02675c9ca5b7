#include "cloth/plate.hpp"

#include "base/error.hpp"
#include "cloth/join.hpp"

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

void add_areas(Sheet<3>& sheet) {
  const auto [nr, ns] = sheet.extent;
  for (int j = 0; j < ns; ++j) {
    for (int i = 0; i < nr; ++i) {
      const double share = (sheet.inside(0, i) ? 1 : 0.5) * (sheet.inside(1, j) ? 1 : 0.5);
      sheet.area.push_back(share * sheet.spacing[0] * sheet.spacing[1]);
    }
  }
}

void add_edges(Sheet<3>& sheet) {
  const auto [nr, ns] = sheet.extent;
  const auto [dr, ds] = sheet.spacing;
  const double area = dr * ds, stiffness = sheet.material.stretch * (1 - sheet.material.poisson);
  const auto edge = [&](const Image<3>& a, const Image<3>& b, double length, bool whole) {
    const double share = whole ? area : 0.5 * area;
    join_strain<1>(sheet, {{{a, b}}}, {0.5 / (length * length)}, -0.5, share * stiffness,
                   stiffening(sheet.material, share));
  };
  for (int j = 0; j < ns; ++j) {
    for (int i = 0; i < nr; ++i) {
      const Image<3> x = sheet.image(i, j);
      if (i < sheet.intervals(0)) edge(x, sheet.image(i + 1, j), dr, sheet.inside(1, j));
      if (j < sheet.intervals(1)) edge(x, sheet.image(i, j + 1), ds, sheet.inside(0, i));
    }
  }
}

/// Shear E_sr = (|X_3 - X_0|^2 - |X_2 - X_1|^2)/(8 area), twist and dilation of quad (i, j).
void add_quad(Sheet<3>& sheet, int i, int j) {
  const auto [dr, ds] = sheet.spacing;
  const double a = dr * ds, wr = 0.25 / (dr * dr), ws = 0.25 / (ds * ds);
  const Material& m = sheet.material;
  const Image<3> x0 = sheet.image(i, j), x1 = sheet.image(i + 1, j);
  const Image<3> x2 = sheet.image(i, j + 1), x3 = sheet.image(i + 1, j + 1);
  join_strain<2>(sheet, {{{x0, x3}, {x1, x2}}}, {0.125 / a, -0.125 / a}, 0, 2 * m.shear * a);
  join_bend(sheet, {{x0, 1 / a}, {x1, -1 / a}, {x2, -1 / a}, {x3, 1 / a}}, 2 * m.torsion * a);
  if (m.poisson > 0)
    join_strain<4>(sheet, {{{x0, x1}, {x2, x3}, {x0, x2}, {x1, x3}}}, {wr, wr, ws, ws}, -1,
                   m.stretch * m.poisson * a);
}

/// Curvatures at node (i, j). Inside,
/// |p|^2 + 2 nu p.q + |q|^2 = (1 - nu)(|p|^2 + |q|^2) + nu |p + q|^2;
/// on a border its least value over the missing one, (1 - nu^2)|p|^2.
void add_curvatures(Sheet<3>& sheet, int i, int j) {
  const double wr = 1 / (sheet.spacing[0] * sheet.spacing[0]);
  const double ws = 1 / (sheet.spacing[1] * sheet.spacing[1]);
  const double nu = sheet.material.poisson;
  const bool along_r = sheet.inside(0, i), along_s = sheet.inside(1, j);
  const double stiffness = sheet.material.bending * sheet.area[sheet.node(i, j)];
  const double own = stiffness * (along_r && along_s ? 1 - nu : 1 - nu * nu);
  const auto add = [&](double factor, double r, double s) {
    std::vector<std::pair<Image<3>, double>> terms = {{sheet.image(i, j), -2 * (r + s)}};
    const auto pair = [&](const Image<3>& a, const Image<3>& b, double w) {
      if (w > 0) terms.insert(terms.end(), {{a, w}, {b, w}});
    };
    pair(sheet.image(i - 1, j), sheet.image(i + 1, j), r);
    pair(sheet.image(i, j - 1), sheet.image(i, j + 1), s);
    join_bend(sheet, terms, factor);
  };
  if (along_r) add(own, wr, 0);
  if (along_s) add(own, 0, ws);
  if (along_r && along_s && nu > 0) add(stiffness * nu, wr, ws);
}

}  // namespace

Sheet<3> make_plate(std::array<int, 2> nodes, std::array<double, 2> spacing,
                    const Material& material, std::array<bool, 2> closed,
                    const std::array<Vec<3>, 2>& period) {
  check(nodes, spacing, material);
  Sheet<3> sheet;
  sheet.extent = nodes;
  sheet.spacing = spacing;
  sheet.material = material;
  sheet.closed = closed;
  sheet.period = period;
  add_areas(sheet);
  add_edges(sheet);
  for (int j = 0; j < sheet.intervals(1); ++j)
    for (int i = 0; i < sheet.intervals(0); ++i) add_quad(sheet, i, j);
  for (int j = 0; j < nodes[1]; ++j)
    for (int i = 0; i < nodes[0]; ++i) add_curvatures(sheet, i, j);
  return sheet;
}

}  // namespace washtub
