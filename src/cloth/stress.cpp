#include "cloth/stress.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "base/error.hpp"

namespace washtub {
namespace {

/// |sigma| of components rr, ss, sr [Pa].
using Components = std::array<double, 3>;

double von_mises(const Components& s) {
  return std::sqrt(s[0] * s[0] - s[0] * s[1] + s[1] * s[1] + 3 * s[2] * s[2]);
}

/// Unit normal at a node, from its neighbours' positions.
Vec<3> normal(const Vec<3>& along_r, const Vec<3>& along_s) {
  return along_s.cross(along_r).normalized();
}

/// Curvature (d e_s/ds . e_n)/|X_s| of three nodes in a row, Eq. (A.5); `project` yields its
/// component along the normal. |X_s| is that of the two edges: between their outer ends it would
/// vanish in a sharp fold.
template <int D, class Project>
double curvature(const Vec<D>& a, const Vec<D>& b, const Vec<D>& c, const Project& project) {
  const Vec<D> turn = (c - b).normalized() - (b - a).normalized();
  return 2 * std::fabs(project(turn)) / ((b - a).norm() + (c - b).norm());
}

/// The first and the last node along an axis that are at most one edge away from the i-th.
template <int D>
std::array<int, 2> around(const Sheet<D>& sheet, int axis, int i) {
  if (sheet.closed[axis]) return {i - 1, i + 1};
  return {std::max(i - 1, 0), std::min(i + 1, sheet.extent[axis] - 1)};
}

/// The i-th node along an axis, or the one next to it if it lies on the border.
template <int D>
int inward(const Sheet<D>& sheet, int axis, int i) {
  return sheet.closed[axis] ? i : std::clamp(i, 1, sheet.extent[axis] - 2);
}

/// The i-th interval along an axis, counted on beyond a seam.
template <int D>
int wrapped(const Sheet<D>& sheet, int axis, int i) {
  return sheet.closed[axis] ? (i + sheet.extent[axis]) % sheet.extent[axis] : i;
}

/// Mean strain of the edges at a node.
struct EdgeMean {
  double size = 0;                      ///< of the magnitudes
  double own = 0;                       ///< the same of strains as Material::effective has them
  double tension = 0, compression = 0;  ///< of their positive and negative parts
  void add(double e, const Material& m, int edges) {
    const double effective = m.effective(e);
    size += std::fabs(e) / edges;
    own += std::fabs(effective) / edges;
    (e > 0 ? tension : compression) += std::fabs(effective) / edges;
  }
};

/// Strains and curvatures of one node of a plate.
class PlateNode {
 public:
  PlateNode(const Sheet<3>& sheet, std::span<const Vec<3>> X, const Strains& strains, int i, int j)
      : sheet_(sheet), X_(X), strains_(strains), at_{i, j} {}

  /// Of the one or two edges along an axis.
  EdgeMean strain(int axis) const {
    const auto [first, last] = around(sheet_, axis, at_[axis]);
    EdgeMean mean;
    for (int k = first; k < last; ++k) mean.add(edge(axis, k), sheet_.material, last - first);
    return mean;
  }

  double curvature(int axis) const {
    const int m = inward(sheet_, axis, at_[axis]);
    const Vec<3> n = normal(tangent(0), tangent(1));
    return washtub::curvature(x(axis, m - 1), x(axis, m), x(axis, m + 1),
                              [&](const Vec<3>& v) { return v.dot(n); });
  }

  /// Mean |e_sr| and mean |tau| of the one, two or four quads about the node.
  std::array<double, 2> shear_and_twist() const {
    const auto [left, right] = around(sheet_, 0, at_[0]);
    const auto [below, above] = around(sheet_, 1, at_[1]);
    std::array<double, 2> sum{};
    for (int j = below; j < above; ++j)
      for (int i = left; i < right; ++i) add_quad(i, j, sum);
    const int quads = (right - left) * (above - below);
    return {sum[0] / quads, sum[1] / quads};
  }

 private:
  double ds(int axis) const { return sheet_.spacing[axis]; }
  /// Strain of an edge in this one's line along an axis.
  double edge(int axis, int place) const {
    const int k = wrapped(sheet_, axis, place);
    return axis == 0 ? strains_.along[0][k + sheet_.intervals(0) * at_[1]]
                     : strains_.along[1][at_[0] + sheet_.extent[0] * k];
  }
  Vec<3> at(int i, int j) const { return sheet_.place(X_, i, j); }
  /// The node in this one's line along an axis.
  Vec<3> x(int axis, int place) const { return axis == 0 ? at(place, at_[1]) : at(at_[0], place); }
  Vec<3> tangent(int axis) const {
    const auto [first, last] = around(sheet_, axis, at_[axis]);
    return x(axis, last) - x(axis, first);
  }
  void add_quad(int i, int j, std::array<double, 2>& sum) const {
    const Vec<3> a = at(i, j), b = at(i + 1, j), c = at(i, j + 1), d = at(i + 1, j + 1);
    const Vec<3> xr = (b - a + d - c) / (2 * ds(0)), xs = (c - a + d - b) / (2 * ds(1));
    const Vec<3> twist = (d - c - b + a) / (ds(0) * ds(1));
    const double lr = ((b - a).norm() + (d - c).norm()) / (2 * ds(0));
    const double ls = ((c - a).norm() + (d - b).norm()) / (2 * ds(1));
    const int quad = wrapped(sheet_, 0, i) + sheet_.intervals(0) * wrapped(sheet_, 1, j);
    sum[0] += std::fabs(strains_.shear[quad]);
    sum[1] += std::fabs(twist.dot(normal(xr, xs))) / (lr * ls);
  }

  const Sheet<3>& sheet_;
  std::span<const Vec<3>> X_;
  const Strains& strains_;
  std::array<int, 2> at_;
};

NodeStress combine(const Components& membrane, const Components& bending) {
  NodeStress out;
  out.membrane = von_mises(membrane);
  out.bending = von_mises(bending);
  for (int c = 0; c < 3; ++c) out.component[c] = membrane[c] + bending[c];
  out.total = von_mises(out.component);
  return out;
}

NodeStress stress(const PlateNode& node, const Material& m) {
  const double q = m.thickness, nu = m.poisson, surface = 6 / (q * q);
  const EdgeMean r = node.strain(0), s = node.strain(1);
  const double kr = node.curvature(0), ks = node.curvature(1);
  const auto [shear, twist] = node.shear_and_twist();
  const double membrane = m.stretch / q, bending = surface * m.bending;
  NodeStress out = combine(
      {membrane * (r.own + nu * s.size), membrane * (s.own + nu * r.size), m.shear / q * shear},
      {bending * (kr + nu * ks), bending * (ks + nu * kr), surface * m.torsion * twist});
  out.tension = 0.5 * membrane * (r.tension + s.tension);
  out.compression = 0.5 * membrane * (r.compression + s.compression);
  return out;
}

/// Of the one or two edges at a node of a thread.
EdgeMean strain(const Sheet<2>& thread, const Strains& strains, int i) {
  const auto [first, last] = around(thread, 1, i);
  EdgeMean mean;
  for (int k = first; k < last; ++k)
    mean.add(strains.along[1][wrapped(thread, 1, k)], thread.material, last - first);
  return mean;
}

/// |kappa| at a node of a thread.
double curvature(const Sheet<2>& thread, std::span<const Vec<2>> X, int i) {
  const int m = inward(thread, 1, i);
  const Vec<2> before = thread.place(X, 0, m - 1), after = thread.place(X, 0, m + 1);
  const Vec<2> along = after - before, n = Vec<2>(-along.y(), along.x()).normalized();
  return curvature(before, X[m], after, [&](const Vec<2>& v) { return v.dot(n); });
}

void check(const Material& m) {
  if (!(m.thickness > 0)) throw InputError("stress needs the cloth's thickness > 0");
}

}  // namespace

void find_stress(const Sheet<3>& plate, std::span<const Vec<3>> X, const Strains& strains,
                 std::span<NodeStress> out) {
  check(plate.material);
  for (int j = 0; j < plate.extent[1]; ++j)
    for (int i = 0; i < plate.extent[0]; ++i)
      out[plate.node(i, j)] = stress(PlateNode(plate, X, strains, i, j), plate.material);
}

void find_stress(const Sheet<2>& thread, std::span<const Vec<2>> X, const Strains& strains,
                 std::span<NodeStress> out) {
  check(thread.material);
  const Material& m = thread.material;
  const double q = m.thickness, membrane = m.stretch / q;
  for (int i = 0; i < thread.nodes(); ++i) {
    NodeStress& o = out[i];
    const EdgeMean e = strain(thread, strains, i);
    o.membrane = membrane * e.own;
    o.tension = membrane * e.tension;
    o.compression = membrane * e.compression;
    o.bending = 6 * m.bending * curvature(thread, X, i) / (q * q);
    o.total = o.component[1] = o.membrane + o.bending;
  }
}

}  // namespace washtub
