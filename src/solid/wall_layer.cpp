#include "solid/wall_layer.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

constexpr double almost_closed = 1e-3;  // open fraction too small for a pressure gradient to act on

}  // namespace

template <int D>
double WallLayer<D>::reach() const {
  const auto& h = grid_.mesh().h;
  return h.norm() + 0.5 * h.maxCoeff();
}

/// How much thinner the solid is than a cell is wide across it.
template <int D>
double WallLayer<D>::missing_thickness(const SolidPose& solid, const Vec<3>& x, double psi,
                                       const Vec<3>& normal) const {
  double width = 0;
  for (int d = 0; d < D; ++d) width = std::max(width, std::abs(normal[d]) * grid_.mesh().h[d]);
  const double inside = solid.psi(x + (0.5 * width - psi) * normal);  // width / 2, if thick enough
  return std::max(0.0, 0.5 * width - inside);
}

template <int D>
float WallLayer<D>::close(const SolidPose& solid, const Vec<3>& x, double psi, int d,
                          HeldFace& face) const {
  const auto& h = grid_.mesh().h;
  const Vec<3> n = solid.normal(x, psi, 1e-3 * h.minCoeff());
  double width = 0;
  for (int e = 0; e < D; ++e) width += std::abs(n[e]) * h[e];
  const double distance = -psi - 0.5 * missing_thickness(solid, x, psi, n);
  const double open = distance / std::max(width, h.minCoeff());
  if (open >= 1) return 1;
  if (open < almost_closed) return 0;
  face.wall = solid.velocity(x)[d];
  face.passage = open;
  for (int e = 0; e < D; ++e)
    face.drag += std::max(0.0, std::abs(n[e]) * h[e] / distance - 1) / (h[e] * h[e]);
  return static_cast<float>(open);
}

template class WallLayer<2>;
template class WallLayer<3>;

}  // namespace washtub
