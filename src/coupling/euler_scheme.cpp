#include "coupling/euler_scheme.hpp"

namespace washtub {

template <int D>
void EulerScheme<D>::push() {
  step_.inertia.find_lagging(step_.flow.step_before());
  step_.find_elastic(step_.cloth.position);
  step_.add_up_force();
}

template <int D>
void EulerScheme<D>::move() {
  const double dt = step_.dt();
  for (std::size_t i = 0; i < step_.next.size(); ++i)
    step_.next[i] = step_.cloth.position[i] + dt * step_.water[i];
  step_.measure_strain();
}

template class EulerScheme<2>;
template class EulerScheme<3>;

}  // namespace washtub
