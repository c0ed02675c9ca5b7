#include "coupling/inertia.hpp"

namespace washtub {

template <int D>
void Inertia<D>::find_lagging(double before) {
  for (std::size_t i = 0; i < force_.size(); ++i)
    force_[i] = before > 0
                    ? Vec<D>(-mass_[i] / before * (cloth_.velocity[i] - cloth_.velocity_before[i]))
                    : Vec<D>(Vec<D>::Zero());
}

template <int D>
void Inertia<D>::find(int node, int component, const Nodes& next, double dt) {
  const double x = cloth_.position[node][component], v = cloth_.velocity[node][component];
  force_[node][component] = -mass_[node] * (next[node][component] - x - dt * v) / (dt * dt);
}

template class Inertia<2>;
template class Inertia<3>;

}  // namespace washtub
