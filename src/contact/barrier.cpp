#include "contact/barrier.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

constexpr double least = 0.02;      // of the smallest spacing, kept even by nodes that start nearer
constexpr int passes = 3;           // over the surfaces, for corners between them
constexpr double rounding = 1e-12;  // of half the widest spacing
constexpr double clamp = 3;         // how far a pin frees its neighbours, in widest cell edges

}  // namespace

template <int D>
Barrier<D>::Barrier(const Grid<D>& grid, const DomainMapping<D>& mapping, const Cloth<D>& cloth,
                    double soft)
    : grid_(grid),
      mapping_(mapping),
      widest_(0.5 * grid.mesh().h.maxCoeff()),
      soft_(soft),
      kept_(cloth.position.size(), 0),
      clearance_(cloth.position.size(), 0),
      alone_(cloth.position.size(), 0),
      accepted_(cloth.position) {
  const auto& mesh = grid.mesh();
  const Vec<D> middle = mesh.lower + 0.5 * mesh.size();
  for (const auto& solid : mapping.solids()) {
    const Vec<D> off = middle - solid.centre.template head<D>();
    fastest_ = std::max(fastest_, solid.drive.peak() * (off.norm() + 0.5 * mesh.size().norm()));
  }
  free_clamps(cloth);
  std::vector<Vec<D>> X = cloth.position;
  accept(X, 0);
}

template <int D>
void Barrier<D>::free_clamps(const Cloth<D>& cloth) {
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto X = cloth.piece(g, p);
      for (const int pin : g.pinned)
        for (int n = 0; n < g.sheet.nodes(); ++n) {
          if ((X[static_cast<std::size_t>(n)] - X[static_cast<std::size_t>(pin)]).norm() >
              2 * clamp * widest_)
            continue;
          bool close = n == pin;
          for_near(X[static_cast<std::size_t>(n)],
                   [&](const Near& s) { close = close || s.psi > -margin(s.normal); });
          if (close) alone_[static_cast<std::size_t>(g.node(p, n))] = 1;
        }
    }
}

template <int D>
double Barrier<D>::margin(const Vec<D>& normal) const {
  return 0.5 * normal.cwiseProduct(grid_.mesh().h).norm();
}

template <int D>
Vec<D> Barrier<D>::inside(Vec<D> x) const {
  const auto& mesh = grid_.mesh();
  for (int d = 0; d < D; ++d) {
    const double length = mesh.h[d] * mesh.cells[d];
    if (mesh.periodic[d]) x[d] -= length * std::floor((x[d] - mesh.lower[d]) / length);
  }
  return x;
}

/// Distance and direction of one surface.
template <int D>
auto Barrier<D>::look(Surface surface, const Vec<D>& x) const -> Near {
  if (surface >= 0) {
    const SolidPose& pose = mapping_.poses()[static_cast<std::size_t>(surface)];
    const Vec<3> point = in_space<D>(inside(x));
    return {pose.psi(point), pose.normal(point, 1e-3 * widest_).template head<D>(), surface};
  }
  const int d = (-1 - surface) / 2;
  const auto& mesh = grid_.mesh();
  if ((-1 - surface) % 2 == 0) return {mesh.lower[d] - x[d], -Vec<D>::Unit(d), surface};
  return {x[d] - mesh.lower[d] - mesh.size()[d], Vec<D>::Unit(d), surface};
}

template <int D>
template <class Visit>
double Barrier<D>::for_near(const Vec<D>& x, Visit&& visit) const {
  double clear = 1e30;
  const auto meet = [&](double psi, Surface surface) {
    if (psi <= -2 * widest_)
      clear = std::min(clear, -psi - widest_);
    else
      visit(look(surface, x));
  };
  const auto& poses = mapping_.poses();
  const Vec<3> point = in_space<D>(inside(x));
  for (std::size_t s = 0; s < poses.size(); ++s) meet(poses[s].psi(point), static_cast<int>(s));
  const auto& mesh = grid_.mesh();
  for (int d = 0; d < D; ++d) {
    const double high = mesh.lower[d] + mesh.h[d] * mesh.cells[d];
    if (mesh.periodic[d]) {  // images that the solids beyond it have in the box are not looked at
      if (!poses.empty()) clear = std::min({clear, point[d] - mesh.lower[d], high - point[d]});
      continue;
    }
    meet(mesh.lower[d] - x[d], -1 - 2 * d);
    meet(x[d] - high, -2 - 2 * d);
  }
  return clear;
}

/// How near to a surface a node may be after a step dt [m].
template <int D>
double Barrier<D>::distance_kept(int node, const Vec<D>& normal, double dt) const {
  const double before = kept_[static_cast<std::size_t>(node)];
  const double least = std::min(margin(normal), before);
  if (!(soft_ > 0 && dt > 0) || before >= 2 * widest_) return least;
  return least + std::exp(-dt / soft_) * (before - least);
}

/// Moves x out of the forbidden layer along the normals; returns whether it had to. `depth` grows
/// to how deep x was.
template <int D>
bool Barrier<D>::project(Vec<D>& x, int node, double& depth) const {
  bool moved = false;
  for (int pass = 0; pass < passes; ++pass) {
    double worst = 0;
    Vec<D> normal = Vec<D>::Zero();
    for_near(x, [&](const Near& s) {
      const double excess = s.psi + distance_kept(node, s.normal, 0);
      if (excess > worst) worst = excess, normal = s.normal;
      if (pass == 0) depth = std::max(depth, s.psi);
    });
    if (worst <= rounding * widest_) break;
    x -= worst * normal;
    moved = true;
  }
  return moved;
}

/// What a node and the solids near it may have moved towards each other.
template <int D>
double Barrier<D>::travel(const Vec<D>& moved, double dt) const {
  return moved.norm() + fastest_ * dt;
}

template <int D>
const std::vector<typename Barrier<D>::Touch>& Barrier<D>::find(const std::vector<Vec<D>>& X,
                                                                double dt) {
  touches_.clear();
  double depth = 0;
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (alone_[i] || clearance_[i] > travel(X[i] - accepted_[i], dt)) continue;
    const int node = static_cast<int>(i);
    for_near(X[i], [&](const Near& s) {
      depth = std::max(depth, s.psi);
      const double excess = s.psi + distance_kept(node, s.normal, dt);
      if (excess > rounding * widest_) touches_.push_back({node, s.surface, excess, s.normal});
    });
  }
  if (!first_depth_) first_depth_ = depth;
  return touches_;
}

template <int D>
auto Barrier<D>::look(int node, Surface surface, const Vec<D>& x, double dt) const -> Touch {
  const Near near = look(surface, x);
  return {node, surface, near.psi + distance_kept(node, near.normal, dt), near.normal};
}

template <int D>
Vec<D> Barrier<D>::way(Surface surface, const Vec<D>& x, double dt) const {
  if (surface < 0) return Vec<D>::Zero();
  const Solid& solid = mapping_.solids()[static_cast<std::size_t>(surface)];
  const double now = mapping_.time();
  const double swept = solid.drive.angle(now) - solid.drive.angle(now - dt);
  const Vec<D> arm = inside(x) - solid.centre.template head<D>();
  Vec<D> moved = arm;
  moved[0] = std::cos(swept) * arm[0] - std::sin(swept) * arm[1];
  moved[1] = std::sin(swept) * arm[0] + std::cos(swept) * arm[1];
  return moved - arm;
}

/// Moves a node that may be near a surface to where it is allowed, and notes how near it is then.
template <int D>
void Barrier<D>::find_place(Vec<D>& x, std::size_t node, Report& report) {
  double nearest = 1e30;
  report.touched += project(x, static_cast<int>(node), report.depth);
  bool near = false;
  const double clear = for_near(x, [&](const Near& s) {
    near = true;
    nearest = std::min(nearest, -s.psi);
  });
  report.penetration = std::max(report.penetration, -nearest);
  clearance_[node] = near ? 0 : clear;
  kept_[node] = std::max(nearest, least * grid_.mesh().h.minCoeff());
}

template <int D>
typename Barrier<D>::Report Barrier<D>::accept(std::vector<Vec<D>>& X, double dt) {
  Report report;
  for (std::size_t i = 0; i < X.size(); ++i) {
    if (alone_[i]) continue;
    clearance_[i] -= travel(X[i] - accepted_[i], dt);
    if (clearance_[i] <= 0) find_place(X[i], i, report);
    accepted_[i] = X[i];
  }
  report.depth = first_depth_.value_or(report.depth);
  first_depth_.reset();
  return report;
}

template class Barrier<2>;
template class Barrier<3>;

}  // namespace washtub
