#include "coupling/broyden_scheme.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace washtub {
namespace {

// The Broyden iteration ends where no node moves past the water by more than a part of the fastest
// node's way, so that slip does not add up over many short steps, and, where steps are long, by
// more than a part of the node spacing, which is the error of the strain.
constexpr double slip_allowed = 2e-3;    // of the longest way of a node in this step
constexpr double strain_allowed = 1e-3;  // of the node spacing
constexpr double least_allowed = 1e-7;   // of the node spacing, for cloth at rest
constexpr int most_iterations = 12;

}  // namespace

template <int D>
BroydenScheme<D>::BroydenScheme(CoupledStep<D>& step)
    : step_(step), residual_(step.next.size(), Vec<D>::Zero()) {
  for (const auto& g : step.cloth.groups)
    spacing_.insert(spacing_.end(), static_cast<std::size_t>(g.nodes()),
                    g.sheet.smallest_spacing());
}

/// Force of the cloth at `next`.
template <int D>
void BroydenScheme<D>::find_force() {
  step_.find_elastic(step_.next);
  for (int i = 0; i < step_.cloth.nodes(); ++i)
    for (int c = 0; c < D; ++c) step_.inertia.find(i, c, step_.next, step_.dt());
  step_.add_up_force();
}

/// The first guess of X^n+1 is forward Euler with the velocity of the step before.
template <int D>
void BroydenScheme<D>::push() {
  const double dt = step_.dt();
  step_.flow.keep_prediction();
  broyden_.start();
  for (std::size_t i = 0; i < step_.next.size(); ++i)
    step_.next[i] = step_.cloth.position[i] + dt * step_.cloth.velocity[i];
  find_force();
}

/// R = X - X^n - dt U; returns its largest size over what is allowed.
template <int D>
double BroydenScheme<D>::find_residual() {
  const double dt = step_.dt();
  double way = 0, largest = 0;
  for (const auto& u : step_.water) way = std::max(way, dt * u.norm());
  for (std::size_t i = 0; i < residual_.size(); ++i) {
    residual_[i] = step_.next[i] - step_.cloth.position[i] - dt * step_.water[i];
    const double allowed =
        std::clamp(slip_allowed * way, least_allowed * spacing_[i], strain_allowed * spacing_[i]);
    const double r = residual_[i].norm() / allowed;
    if (!(r <= largest)) largest = r;  // keeps what is not a number
  }
  return largest;
}

template <int D>
bool BroydenScheme<D>::again() {
  const double left = find_residual();
  if (left <= 1) return false;
  if (!std::isfinite(left) || broyden_.count() == most_iterations)
    throw RunError("the Broyden iteration of the cloth did not converge in " +
                   std::to_string(most_iterations) +
                   " steps; try a smaller time.step, or coupling.scheme = \"implicit\"");
  const auto& step = broyden_.step(residual_);
  for (std::size_t i = 0; i < step.size(); ++i) step_.next[i] += step[i];
  step_.report.iterations = broyden_.count();
  find_force();
  step_.flow.return_to_prediction();
  return true;
}

template class BroydenScheme<2>;
template class BroydenScheme<3>;

}  // namespace washtub
