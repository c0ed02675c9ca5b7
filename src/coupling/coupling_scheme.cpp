#include "coupling/coupling_scheme.hpp"

#include "coupling/broyden_scheme.hpp"
#include "coupling/euler_scheme.hpp"
#include "coupling/implicit_scheme.hpp"

namespace washtub {

template <int D>
std::unique_ptr<CouplingScheme<D>> make_scheme(Scheme scheme, CoupledStep<D>& step,
                                               Barrier<D>& barrier, Contact<D>* contact) {
  switch (scheme) {
    case Scheme::explicit_euler:
      return std::make_unique<EulerScheme<D>>(step);
    case Scheme::broyden:
      return std::make_unique<BroydenScheme<D>>(step);
    case Scheme::implicit:
      break;
  }
  return std::make_unique<ImplicitScheme<D>>(step, barrier, contact);
}

template std::unique_ptr<CouplingScheme<2>> make_scheme(Scheme, CoupledStep<2>&, Barrier<2>&,
                                                        Contact<2>*);
template std::unique_ptr<CouplingScheme<3>> make_scheme(Scheme, CoupledStep<3>&, Barrier<3>&,
                                                        Contact<3>*);

}  // namespace washtub
