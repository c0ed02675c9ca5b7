#include "coupling/barrier.hpp"

#include <algorithm>

namespace washtub {

template <int D>
Barrier<D>::Barrier(const Grid<D>& grid, const DomainMapping<D>& mapping, int nodes)
    : grid_(grid), mapping_(mapping), clearance_(static_cast<std::size_t>(nodes), 0) {}

/// Half a cell, measured along the normal.
template <int D>
double Barrier<D>::margin(const Vec<D>& normal) const {
  return 0.5 * normal.cwiseProduct(grid_.mesh().h).norm();
}

template <int D>
bool Barrier<D>::hold_from_solids(Vec<D>& x, Vec<D>& v, double& clearance, Report& report) const {
  const double widest = 0.5 * grid_.mesh().h.maxCoeff();
  bool touched = false;
  clearance = 1e30;
  for (const auto& solid : mapping_.poses()) {
    const double psi = solid.psi(in_space<D>(x));
    if (psi <= -widest) {
      clearance = std::min(clearance, -widest - psi);
      continue;
    }
    clearance = 0;
    const Vec<3> n3 = solid.normal(in_space<D>(x), 1e-3 * widest);
    const Vec<D> n = n3.template head<D>();
    const double excess = psi + margin(n);
    if (excess <= 0) continue;
    touched = true;
    report.penetration = std::max(report.penetration, psi);
    x -= excess * n;
    const Vec<D> relative = v - solid.velocity(in_space<D>(x)).template head<D>();
    v -= std::max(0.0, relative.dot(n)) * n;
  }
  return touched;
}

template <int D>
bool Barrier<D>::hold_from_sides(Vec<D>& x, Vec<D>& v) const {
  const auto& mesh = grid_.mesh();
  bool touched = false;
  for (int d = 0; d < D; ++d) {
    if (mesh.periodic[d]) continue;
    const double low = mesh.lower[d] + 0.5 * mesh.h[d];
    const double high = mesh.lower[d] + mesh.h[d] * (mesh.cells[d] - 0.5);
    if (x[d] >= low && x[d] <= high) continue;
    touched = true;
    v[d] = x[d] < low ? std::max(v[d], 0.0) : std::min(v[d], 0.0);
    x[d] = std::clamp(x[d], low, high);
  }
  return touched;
}

template <int D>
typename Barrier<D>::Report Barrier<D>::hold(Cloth<D>& cloth, double dt) {
  Report report;
  double fastest = 0;  // of any solid's matter near the cloth
  const Vec<D> far = grid_.mesh().size();
  for (const auto& solid : mapping_.solids())
    fastest = std::max(fastest, std::abs(solid.drive.speed(mapping_.time())) * far.norm());
  for (std::size_t i = 0; i < clearance_.size(); ++i) {
    auto& x = cloth.position[i];
    auto& v = cloth.velocity[i];
    bool touched = hold_from_sides(x, v);
    clearance_[i] -= 1.5 * dt * (v.norm() + fastest);
    if (clearance_[i] <= 0) touched = hold_from_solids(x, v, clearance_[i], report) || touched;
    report.touched += touched;
  }
  return report;
}

template class Barrier<2>;
template class Barrier<3>;

}  // namespace washtub
