#include "report/surface.hpp"

#include <openvdb/openvdb.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <functional>

namespace washtub {
namespace {

constexpr std::size_t most_triangles = 20000;
/// How readily flat parts of closed surfaces get larger triangles, 0 to 1. More of it makes creases
/// ragged; open surfaces have none, since it would refine their rims.
constexpr double adaptivity = 0.002;
constexpr int leaf = 8;  ///< voxels along an edge of the library's blocks

using Psi = std::function<double(const Vec<3>&)>;

/// Signed distance, or a bound of it, to the faces of a box, > 0 inside.
double psi_of(const Bounds& box, const Vec<3>& x) {
  return std::min((x - box.lower).minCoeff(), (box.upper - x).minCoeff());
}

/// A region cut by a box, on a lattice of points `voxel` apart.
struct Cut {
  const Psi& inner;
  Bounds box;
  double voxel;

  double psi(const Vec<3>& x) const { return std::min(inner(x), psi_of(box, x)); }
  Vec<3> point(const openvdb::Coord& n) const {
    return box.lower + voxel * (Vec<3>(n.x(), n.y(), n.z()) - Vec<3>::Constant(2.5));
  }
  Vec<3> gradient(const Vec<3>& x) const {
    const double step = 1e-3 * voxel;
    Vec<3> g;
    for (int d = 0; d < 3; ++d)
      g[d] = (psi(x + step * Vec<3>::Unit(d)) - psi(x - step * Vec<3>::Unit(d))) / (2 * step);
    return g;
  }
};

/// Fills one block of voxels, unless it is all inside or all outside.
void fill(const Cut& cut, const openvdb::Coord& first, openvdb::FloatGrid& grid) {
  const Vec<3> middle = cut.point(first) + Vec<3>::Constant(0.5 * (leaf - 1) * cut.voxel);
  const double at_middle = cut.psi(middle);
  if (std::abs(at_middle) > 0.5 * leaf * std::sqrt(3.0) * cut.voxel) {
    if (at_middle > 0) grid.tree().addTile(1, first, -grid.background(), false);
    return;
  }
  auto access = grid.getAccessor();
  for (int n = 0; n < leaf * leaf * leaf; ++n) {
    const openvdb::Coord at = first.offsetBy(n % leaf, n / leaf % leaf, n / (leaf * leaf));
    access.setValue(at, static_cast<float>(-cut.psi(cut.point(at))));
  }
}

/// The signed distance as the library has it: negative inside, known near the surface.
openvdb::FloatGrid::Ptr sample(const Cut& cut) {
  openvdb::initialize();
  auto grid = openvdb::FloatGrid::create(static_cast<float>(3 * cut.voxel));
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  const Vec<3> count = (cut.box.upper - cut.box.lower) / cut.voxel + Vec<3>::Constant(5);
  for (int k = 0; k < count.z(); k += leaf)
    for (int j = 0; j < count.y(); j += leaf)
      for (int i = 0; i < count.x(); i += leaf) fill(cut, {i, j, k}, *grid);
  return grid;
}

/// Puts a vertex onto the surface, and onto its edge or corner if it is near one: where the tangent
/// planes seen from around it meet best, at most a voxel away.
Vec<3> sharpen(const Cut& cut, const Vec<3>& vertex) {
  Eigen::Matrix3d sum = 0.02 * Eigen::Matrix3d::Identity();
  Vec<3> right = Vec<3>::Zero();
  for (int corner = 0; corner < 8; ++corner) {
    const Vec<3> away =
        0.5 * cut.voxel * Vec<3>(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
    const Vec<3> g = cut.gradient(vertex + away);
    sum += g * g.transpose();
    right += g * (g.dot(away) - cut.psi(vertex + away));
  }
  Vec<3> move = sum.ldlt().solve(right);
  if (move.norm() > cut.voxel) move *= cut.voxel / move.norm();
  const Vec<3> x = vertex + move, g = cut.gradient(x);
  const double square = g.squaredNorm();
  return square > 0.1 ? Vec<3>(x - cut.psi(x) / square * g) : x;
}

/// Whether the box, not the solid itself, makes the surface here, or no more than a sliver of it.
bool on_cut(const Cut& cut, const Surface& s, const std::array<std::uint32_t, 3>& triangle) {
  Vec<3> middle = Vec<3>::Zero();
  for (const std::uint32_t v : triangle)
    middle += Eigen::Map<const Eigen::Vector3f>(s.vertices[v].data()).cast<double>() / 3;
  return psi_of(cut.box, middle) < cut.inner(middle) + 0.02 * cut.voxel;
}

/// Drops vertices that no triangle uses.
void tidy(Surface& s) {
  constexpr std::uint32_t unused = ~0U;
  std::vector<std::uint32_t> number(s.vertices.size(), unused);
  std::vector<std::array<float, 3>> kept;
  for (auto& triangle : s.triangles)
    for (std::uint32_t& v : triangle) {
      if (number[v] == unused) {
        number[v] = static_cast<std::uint32_t>(kept.size());
        kept.push_back(s.vertices[v]);
      }
      v = number[v];
    }
  s.vertices = std::move(kept);
}

Surface mesh(const Cut& cut, bool open) {
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec3I> triangles;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*sample(cut), points, triangles, quads, 0, open ? 0 : adaptivity);
  Surface s;
  for (const auto& p : points) {
    const Vec<3> x = cut.box.lower + cut.voxel * Vec<3>(p.x() - 2.5, p.y() - 2.5, p.z() - 2.5);
    const Eigen::Vector3f at = sharpen(cut, x).cast<float>();
    s.vertices.push_back({at.x(), at.y(), at.z()});
  }
  for (const auto& t : triangles) s.triangles.push_back({t[0], t[2], t[1]});
  const auto length = [&](std::uint32_t a, std::uint32_t b) {
    using Point = Eigen::Map<const Eigen::Vector3f>;
    return (Point(s.vertices[a].data()) - Point(s.vertices[b].data())).norm();
  };
  for (const auto& q : quads) {
    const int turn = length(q[0], q[2]) <= length(q[1], q[3]) ? 0 : 1;
    const auto corner = [&](int n) { return q[(n + turn) % 4]; };
    s.triangles.push_back({corner(0), corner(2), corner(1)});
    s.triangles.push_back({corner(0), corner(3), corner(2)});
  }
  return s;
}

Surface surface(const Psi& psi, const Bounds& within, double voxel, bool open) {
  const Cut cut{psi, within, voxel};
  Surface s = mesh(cut, open);
  if (open) std::erase_if(s.triangles, [&](const auto& t) { return on_cut(cut, s, t); });
  tidy(s);
  return s;
}

/// The part of space about the solid's centre whose surface can be seen in the box.
Bounds reach(const Solid& solid, const SurfaceBox& box) {
  Bounds seen{box.lower - solid.centre, box.upper - solid.centre};
  if (solid.drive.moving()) {
    const Vec<3> far = seen.lower.cwiseAbs().cwiseMax(seen.upper.cwiseAbs());
    const double radius = std::hypot(far.x(), far.y());
    seen.lower.head<2>().setConstant(-radius);
    seen.upper.head<2>().setConstant(radius);
  }
  const Bounds own = solid.shape.bounds();
  const double room = 0.02 * (seen.upper - seen.lower).norm();
  for (int d = 0; d < (box.plane ? 2 : 3); ++d) {
    seen.lower[d] = std::max(seen.lower[d], own.lower[d] - room);
    seen.upper[d] = std::min(seen.upper[d], own.upper[d] + room);
  }
  return seen;
}

/// About as fine as the number of triangles allows.
template <class Make>
Surface fit(double voxel, const Make& make) {
  Surface s;
  for (int attempt = 0; attempt < 4; ++attempt) {
    Surface next = make(voxel);
    const double share = static_cast<double>(next.triangles.size()) / most_triangles;
    if (share == 0) break;
    s = std::move(next);
    if (share > 0.4 && share <= 1) break;
    voxel *= 1.05 * std::sqrt(std::max(share, 0.1));
  }
  return s;
}

/// Halves the voxels until a thin solid is met.
template <class Make>
Surface refine(double voxel, const Make& make) {
  Surface s;
  for (int attempt = 0; attempt < 4 && s.triangles.empty(); ++attempt) s = make(voxel *= 0.5);
  if (s.triangles.size() > most_triangles) return {};
  return s;
}

/// A thin solid, made thicker along its thin axes and set right afterwards. Stretched space has
/// smaller slopes of psi, so that it stays a bound of the distance.
Surface stretched_surface(const Shape& shape, const Bounds& within, double voxel, bool open) {
  constexpr double voxels = 12;  // across the solid
  const Bounds own = shape.bounds();
  const Vec<3> stretch =
      (voxels * voxel * (own.upper - own.lower).cwiseInverse()).cwiseMax(Vec<3>::Ones());
  const Psi psi = [&](const Vec<3>& x) { return shape.psi(x.cwiseQuotient(stretch)); };
  const Vec<3> margin = Vec<3>::Constant(4 * voxel).cwiseQuotient(stretch);
  const Bounds box{within.lower.cwiseMax(own.lower - margin).cwiseProduct(stretch),
                   within.upper.cwiseMin(own.upper + margin).cwiseProduct(stretch)};
  Surface s = surface(psi, box, voxel, open);
  for (auto& v : s.vertices)
    for (std::size_t d = 0; d < 3; ++d)
      v[d] /= static_cast<float>(stretch[static_cast<Eigen::Index>(d)]);
  return s;
}

/// All along z like at z = 0: made a few voxels thick, where edges are sharp, and then set right.
Surface plane_surface(const Shape& shape, const Bounds& within, double voxel) {
  const double thick = 6 * voxel;
  Bounds box = within;
  box.lower.z() = 0;
  box.upper.z() = thick;
  const Psi psi = [&](const Vec<3>& x) { return shape.psi({x.x(), x.y(), 0}); };
  Surface s = surface(psi, box, voxel, false);
  const double z = within.lower.z(), height = within.upper.z() - z;
  for (auto& v : s.vertices) {
    const double share = v[2] / thick;
    const bool end = share < 0.02 || share > 0.98;
    v[2] = static_cast<float>(z + height * (end ? std::round(share) : share));
  }
  return s;
}

}  // namespace

Surface surface(const Shape& shape, const Bounds& within, double voxel, bool open) {
  return surface([&](const Vec<3>& x) { return shape.psi(x); }, within, voxel, open);
}

bool reaches_into(const Solid& solid, const SurfaceBox& box) {
  const Bounds own = solid.shape.bounds();
  if (!own.lower.allFinite() || !own.upper.allFinite()) return false;
  const int axes = box.plane ? 2 : 3;
  const Vec<3> lower = own.lower + solid.centre, upper = own.upper + solid.centre;
  return (lower.head(axes).array() < box.upper.head(axes).array()).all() &&
         (upper.head(axes).array() > box.lower.head(axes).array()).all();
}

std::optional<Surface> surface(const Solid& solid, const SurfaceBox& box) {
  const Bounds within = reach(solid, box);
  const Vec<3> size = within.upper - within.lower;
  if (!(size.minCoeff() > 0)) return {};
  const double voxel = (box.plane ? size.head<2>().norm() : size.norm()) / 120;
  const auto make = [&](double v) {
    return box.plane ? plane_surface(solid.shape, within, v)
                     : surface(solid.shape, within, v, !solid.drive.moving());
  };
  Surface s = fit(voxel, make);
  if (s.triangles.empty() && reaches_into(solid, box))
    s = box.plane ? refine(voxel, make) : fit(voxel, [&](double v) {
      return stretched_surface(solid.shape, within, v, !solid.drive.moving());
    });
  if (s.triangles.empty()) return {};
  return s;
}

}  // namespace washtub
