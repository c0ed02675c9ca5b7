#include "solid/surface_water.hpp"

namespace washtub {
namespace {

constexpr int samples = 4;  // along each edge of a cell that a surface cuts

}  // namespace

template <int D>
SurfaceWater<D>::SurfaceWater(const Grid<D>& grid, const DomainMapping<D>& mapping, double density)
    : grid_(grid), mapping_(mapping), cell_mass_(density * grid.mesh().cell_volume()) {
  for (std::size_t s = 0; s < mapping.solids().size(); ++s)
    displaced_.push_back(mapping.solids()[s].drive.moving() ? integrate(s) : Displaced());
}

/// Share of the cell around x that a solid takes up.
template <int D>
double SurfaceWater<D>::share_inside(std::size_t solid, const Vec<D>& x) const {
  const auto& pose = mapping_.poses()[solid];
  const auto& h = grid_.mesh().h;
  const double psi = pose.psi(in_space<D>(x));
  if (std::abs(psi) > 0.5 * h.norm()) return psi > 0 ? 1 : 0;
  int inside = 0, all = 0;
  Index<D> n{};
  const auto next = [&] {
    for (int d = 0; d < D; ++d) {
      if (++n[d] < samples) return true;
      n[d] = 0;
    }
    return false;
  };
  do {
    Vec<D> at = x;
    for (int d = 0; d < D; ++d) at[d] += ((n[d] + 0.5) / samples - 0.5) * h[d];
    inside += pose.psi(in_space<D>(at)) > 0;
    ++all;
  } while (next());
  return static_cast<double>(inside) / all;
}

/// Over the cells around the faces along x and y, as they carry momentum. A mapping that opens
/// faces in part knows where the surface is, and the water that the solid displaces is that within
/// it; a sharp one displaces the cells that it closes.
template <int D>
typename SurfaceWater<D>::Displaced SurfaceWater<D>::integrate(std::size_t solid) const {
  const auto& block = grid_.block();
  const Vec<3>& centre = mapping_.solids()[solid].centre;
  const auto held = mapping_.held();
  Displaced sum;
  for (int c = 0; c < 2; ++c) {
    const bool in_part = held[c]->size() > 0;
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (int i = 0; i < block.width(); ++i) {
          Index<D> cell{};
          cell[0] = i;
          if constexpr (D == 3) cell[1] = j;
          cell[D - 1] = k;
          const long p = block.at(cell);
          if (mapping_.owner(c)[p] != solid) continue;
          const Vec<D> x = grid_.position(cell, c);
          const double arm = x[1 - c] - centre[1 - c];
          const double share = in_part ? share_inside(solid, x) : mapping_.open()[c][p] <= 0;
          const double mass = cell_mass_ * share;
          sum.first[1 - c] += mass * arm;
          sum.second += mass * arm * arm;
        }
  }
  return sum;
}

template <int D>
Load<D> SurfaceWater<D>::momentum(std::size_t solid, const std::array<Field, D>& u) const {
  const auto& body = mapping_.solids()[solid];
  const auto& pose = mapping_.poses()[solid];
  Load<D> sum;
  for (int c = 0; c < D; ++c)
    mapping_.for_surface(solid, c, [&](const SurfaceFace<D>& face) {
      const double rigid = pose.velocity(in_space<D>(face.x))[c];
      const float open = mapping_.open()[c][face.p];
      const double past = open > 0 ? mapping_.content(open) * (u[c][face.p] - rigid) : 0;
      sum.add(face.x, body.centre, c, cell_mass_ * (rigid + past));
    });
  const double angle = body.drive.angle(mapping_.time()), omega = body.drive.speed(mapping_.time());
  const Vec<2> r = Eigen::Rotation2Dd(angle) * displaced_[solid].first;
  sum.force.template head<2>() -= omega * Vec<2>(-r[1], r[0]);
  sum.torque -= omega * displaced_[solid].second;
  return sum;
}

template <int D>
Load<D> SurfaceWater<D>::joined(std::size_t solid, const std::array<Field, D>& u) const {
  Load<D> sum;
  for (const auto& face : mapping_.changed()) {
    if (face.solid != solid || (face.before < 1) == (face.after < 1)) continue;
    const double sign = face.after < 1 ? 1 : -1;
    sum.add(face.x, mapping_.solids()[solid].centre, face.axis,
            sign * cell_mass_ * u[face.axis][face.p]);
  }
  return sum;
}

template class SurfaceWater<2>;
template class SurfaceWater<3>;

}  // namespace washtub
