#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"
#include "coupling/coupling.hpp"

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

/// The first guess of X^n+1: forward Euler with the velocity of the step before.
template <int D>
void Coupling<D>::start_iteration(double dt) {
  flow_.keep_prediction();
  broyden_.start();
  for (std::size_t i = 0; i < next_.size(); ++i)
    next_[i] = cloth_.position[i] + dt * cloth_.velocity[i];
  find_elastic(next_);
  find_implicit_inertia(dt, true);
}

/// R = X - X^n - dt U of the nodes that are not pinned; returns its largest size over what is
/// allowed.
template <int D>
double Coupling<D>::find_residual(double dt) {
  boundary_.interpolate(flow_.velocity(), water_);
  for (const int node : pinned_) water_[static_cast<std::size_t>(node)].setZero();
  double way = 0, largest = 0;
  for (const auto& u : water_) way = std::max(way, dt * u.norm());
  for (std::size_t i = 0; i < next_.size(); ++i) {
    residual_[i] = next_[i] - cloth_.position[i] - dt * water_[i];
    const double allowed =
        std::clamp(slip_allowed * way, least_allowed * size_[i], strain_allowed * size_[i]);
    const double r = residual_[i].norm() / allowed;
    if (!(r <= largest)) largest = r;  // keeps what is not a number
  }
  return largest;
}

template <int D>
bool Coupling<D>::again(double dt) {
  if (scheme_ != Scheme::broyden) return false;
  const double left = find_residual(dt);
  if (left <= 1) return false;
  if (!std::isfinite(left) || broyden_.count() == most_iterations)
    throw RunError("the Broyden iteration of the cloth did not converge in " +
                   std::to_string(most_iterations) +
                   " steps; try a smaller time.step, or coupling.scheme = \"implicit\"");
  const Nodes& step = broyden_.step(residual_);
  for (std::size_t i = 0; i < next_.size(); ++i) next_[i] += step[i];
  report_.iterations = broyden_.count();
  find_elastic(next_);
  find_implicit_inertia(dt, true);
  spread_force();
  flow_.return_to_prediction();
  return true;
}

template class Coupling<2>;
template class Coupling<3>;

}  // namespace washtub
