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

/// (1 - 1/|X_s|^2)/2 of one edge, Eq. (12).
template <int D>
double edge_strain(const Vec<D>& a, const Vec<D>& b, double ds) {
  return 0.5 * (1 - ds * ds / (b - a).squaredNorm());
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

/// Strains and curvatures of one node of a plate.
class PlateNode {
 public:
  PlateNode(const Sheet<3>& sheet, std::span<const Vec<3>> X, int i, int j)
      : sheet_(sheet), X_(X), at_{i, j} {}

  /// Mean |e| of the one or two edges along an axis.
  double strain(int axis) const {
    const int here = at_[axis], end = sheet_.extent[axis] - 1;
    double sum = 0;
    if (here > 0) sum += std::fabs(edge_strain(x(axis, here - 1), x(axis, here), ds(axis)));
    if (here < end) sum += std::fabs(edge_strain(x(axis, here), x(axis, here + 1), ds(axis)));
    return sum / ((here > 0) + (here < end));
  }

  double curvature(int axis) const {
    const int m = std::clamp(at_[axis], 1, sheet_.extent[axis] - 2);
    const Vec<3> n = normal(tangent(0), tangent(1));
    return washtub::curvature(x(axis, m - 1), x(axis, m), x(axis, m + 1),
                              [&](const Vec<3>& v) { return v.dot(n); });
  }

  /// Mean |e_sr| and mean |tau| of the one, two or four quads about the node.
  std::array<double, 2> shear_and_twist() const {
    std::array<double, 2> sum{};
    int quads = 0;
    for (int j = std::max(at_[1] - 1, 0); j <= std::min(at_[1], sheet_.extent[1] - 2); ++j) {
      for (int i = std::max(at_[0] - 1, 0); i <= std::min(at_[0], sheet_.extent[0] - 2); ++i) {
        add_quad(i, j, sum);
        ++quads;
      }
    }
    return {sum[0] / quads, sum[1] / quads};
  }

 private:
  double ds(int axis) const { return sheet_.spacing[axis]; }
  const Vec<3>& at(int i, int j) const { return X_[sheet_.node(i, j)]; }
  /// The node in this one's line along an axis.
  const Vec<3>& x(int axis, int place) const {
    return axis == 0 ? at(place, at_[1]) : at(at_[0], place);
  }
  Vec<3> tangent(int axis) const {
    const int here = at_[axis], end = sheet_.extent[axis] - 1;
    return x(axis, std::min(here + 1, end)) - x(axis, std::max(here - 1, 0));
  }
  void add_quad(int i, int j, std::array<double, 2>& sum) const {
    const Vec<3>&a = at(i, j), &b = at(i + 1, j), &c = at(i, j + 1), &d = at(i + 1, j + 1);
    const Vec<3> xr = (b - a + d - c) / (2 * ds(0)), xs = (c - a + d - b) / (2 * ds(1));
    const Vec<3> twist = (d - c - b + a) / (ds(0) * ds(1));
    const double lr = ((b - a).norm() + (d - c).norm()) / (2 * ds(0));
    const double ls = ((c - a).norm() + (d - b).norm()) / (2 * ds(1));
    const double scale = 1 / (lr * ls);
    sum[0] += 0.5 * std::fabs(xr.dot(xs)) * scale;
    sum[1] += std::fabs(twist.dot(normal(xr, xs))) * scale;
  }

  const Sheet<3>& sheet_;
  std::span<const Vec<3>> X_;
  std::array<int, 2> at_;
};

NodeStress combine(const Components& membrane, const Components& bending) {
  NodeStress out{von_mises(membrane), von_mises(bending), 0, {}};
  for (int c = 0; c < 3; ++c) out.component[c] = membrane[c] + bending[c];
  out.total = von_mises(out.component);
  return out;
}

NodeStress stress(const PlateNode& node, const Material& m) {
  const double q = m.thickness, nu = m.poisson, surface = 6 / (q * q);
  const double err = node.strain(0), ess = node.strain(1);
  const double kr = node.curvature(0), ks = node.curvature(1);
  const auto [shear, twist] = node.shear_and_twist();
  const double membrane = m.stretch / q, bending = surface * m.bending;
  return combine({membrane * (err + nu * ess), membrane * (ess + nu * err), m.shear / q * shear},
                 {bending * (kr + nu * ks), bending * (ks + nu * kr), surface * m.torsion * twist});
}

/// Mean |e_ss| of the one or two edges at a node of a thread.
double strain(const Sheet<2>& thread, std::span<const Vec<2>> X, int i) {
  const int first = std::max(i - 1, 0), last = std::min(i + 1, thread.nodes() - 1);
  double sum = 0;
  for (int k = first; k < last; ++k)
    sum += std::fabs(edge_strain(X[k], X[k + 1], thread.spacing[1]));
  return sum / (last - first);
}

/// |kappa| at a node of a thread.
double curvature(std::span<const Vec<2>> X, int i) {
  const int m = std::clamp(i, 1, static_cast<int>(X.size()) - 2);
  const Vec<2> along = X[m + 1] - X[m - 1], n = Vec<2>(-along.y(), along.x()).normalized();
  return curvature(X[m - 1], X[m], X[m + 1], [&](const Vec<2>& v) { return v.dot(n); });
}

void check(const Material& m) {
  if (!(m.thickness > 0)) throw InputError("stress needs the cloth's thickness > 0");
}

}  // namespace

void find_stress(const Sheet<3>& plate, std::span<const Vec<3>> X, std::span<NodeStress> out) {
  check(plate.material);
  for (int j = 0; j < plate.extent[1]; ++j)
    for (int i = 0; i < plate.extent[0]; ++i)
      out[plate.node(i, j)] = stress(PlateNode(plate, X, i, j), plate.material);
}

void find_stress(const Sheet<2>& thread, std::span<const Vec<2>> X, std::span<NodeStress> out) {
  check(thread.material);
  const Material& m = thread.material;
  const double q = m.thickness;
  for (int i = 0; i < thread.nodes(); ++i) {
    NodeStress& o = out[i];
    o.membrane = m.stretch * strain(thread, X, i) / q;
    o.bending = 6 * m.bending * curvature(X, i) / (q * q);
    o.total = o.component[1] = o.membrane + o.bending;
  }
}

}  // namespace washtub
