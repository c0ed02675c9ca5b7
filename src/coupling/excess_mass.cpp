#include "coupling/excess_mass.hpp"

namespace washtub {

template <int D>
ExcessMass<D>::ExcessMass(const Cloth<D>& cloth)
    : cloth_(cloth), force_(cloth.position.size(), Vec<D>::Zero()) {
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p)
      for (const double area : g.sheet.area) mass_.push_back(g.sheet.material.excess_mass * area);
}

template <int D>
void ExcessMass<D>::find_lagging(double before) {
  for (std::size_t i = 0; i < force_.size(); ++i) {
    force_[i] = mass_[i] * gravity_;
    if (before > 0)
      force_[i] -= mass_[i] / before * (cloth_.velocity[i] - cloth_.velocity_before[i]);
  }
}

template <int D>
void ExcessMass<D>::find(int node, int component, const Nodes& next, double dt) {
  const double x = cloth_.position[node][component], v = cloth_.velocity[node][component];
  force_[node][component] =
      mass_[node] * (gravity_[component] - (next[node][component] - x - dt * v) / (dt * dt));
}

template class ExcessMass<2>;
template class ExcessMass<3>;

}  // namespace washtub
