#include "coupling/coupling.hpp"

#include <algorithm>
#include <cmath>

namespace washtub {
namespace {

// Tight enough that the result does not depend on which pieces are solved side by side.
constexpr double solve_tolerance = 1e-10;  // in node spacings
constexpr double light = 0.1;  // excess mass per ghost mass up to which inertia may lag a step

}  // namespace

template <int D>
Coupling<D>::Coupling(Flow<D>& flow, Cloth<D>& cloth, const DomainMapping<D>& mapping,
                      Kernel kernel, const std::array<std::array<Side<D>, 2>, D>& sides,
                      Scheme scheme, double marker_spacing)
    : flow_(flow),
      cloth_(cloth),
      mapping_(mapping),
      scheme_(scheme),
      boundary_(flow.grid(), cloth, kernel, sides, marker_spacing),
      barrier_(flow.grid(), mapping, cloth) {
  const auto& parallel = flow.grid().parallel();
  for (const auto& g : cloth.groups) {
    solvers_.push_back(std::make_unique<ClothSolver<D>>(g.sheet, g.pinned, solve_tolerance));
    auto& mine = mine_.emplace_back();
    for (int p = 0; p < g.pieces; ++p) {
      if ((g.first_piece + p) % parallel.size() == parallel.rank()) mine.push_back(p);
      for (const double area : g.sheet.area) excess_.push_back(g.sheet.material.excess_mass * area);
      size_.insert(size_.end(), g.sheet.area.size(), g.sheet.smallest_spacing());
      for (const int node : g.pinned) pinned_.push_back(g.node(p, node));
    }
  }
  for (auto& f : provisional_) f = flow.grid().make_field();
  for (auto* n : {&next_, &middle_, &target_, &stiffness_, &mobility_, &carried_, &water_, &free_,
                  &reaction_, &force_, &residual_})
    n->resize(cloth.position.size(), Vec<D>::Zero());
  held_by_.resize(cloth.position.size(), not_held);
  pin_force_.resize(pinned_.size(), Vec<D>::Zero());
}

/// Where the water would carry the nodes, and how easily it is moved there.
template <int D>
void Coupling<D>::find_water(double dt) {
  flow_.provisional(provisional_);
  boundary_.mobility(flow_.openings(), flow_.density(), mobility_);
  boundary_.interpolate(provisional_, water_);
}

template <int D>
void Coupling<D>::find_pins(double dt) {
  for (std::size_t k = 0; k < pinned_.size(); ++k) {
    const auto i = static_cast<std::size_t>(pinned_[k]);
    pin_force_[k] = force_[i] - water_[i].cwiseQuotient(mobility_[i]) / dt;
  }
}

/// Weight and inertia of the mass beyond that of the displaced water, from the last two steps.
template <int D>
void Coupling<D>::find_inertia() {
  for (std::size_t i = 0; i < carried_.size(); ++i) {
    carried_[i] = excess_[i] * gravity_;
    if (last_step_ > 0)
      carried_[i] -= excess_[i] / last_step_ * (cloth_.velocity[i] - cloth_.velocity_before[i]);
  }
}

/// Whether the inertia of a node has to be taken at the new time.
template <int D>
bool Coupling<D>::heavy(std::size_t node, int component) const {
  return excess_[node] * mobility_[node][component] > light;
}

/// Weight and inertia of nodes that move on to `next_`: of the heavy ones or all.
template <int D>
void Coupling<D>::find_implicit_inertia(double dt, bool all) {
  for (std::size_t i = 0; i < carried_.size(); ++i)
    for (int c = 0; c < D; ++c)
      if (all || heavy(i, c))
        carried_[i][c] =
            excess_[i] *
            (gravity_[c] -
             (next_[i][c] - cloth_.position[i][c] - dt * cloth_.velocity[i][c]) / (dt * dt));
}

template <int D>
void Coupling<D>::find_elastic(const Nodes& X) {
  for (const auto& g : cloth_.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto first = static_cast<std::size_t>(g.node(p, 0));
      const auto n = static_cast<std::size_t>(g.sheet.nodes());
      g.sheet.force(std::span(X).subspan(first, n), std::span(cloth_.elastic).subspan(first, n));
    }
}

template <int D>
double Coupling<D>::contact_moment(std::size_t solid) const {
  double moment = 0;
  for (const int node : held_) {
    const auto i = static_cast<std::size_t>(node);
    if (held_by_[i] != static_cast<int>(solid)) continue;
    const Vec<3>& centre = mapping_.solids()[solid].centre;
    const Vec<D>& x = next_[i];
    moment -= (x[0] - centre[0]) * reaction_[i][1] - (x[1] - centre[1]) * reaction_[i][0];
  }
  return moment;
}

/// Spreads the total force of the nodes.
template <int D>
void Coupling<D>::spread_force() {
  for (std::size_t i = 0; i < force_.size(); ++i) force_[i] = cloth_.elastic[i] + carried_[i];
  add_reactions();
  for (std::size_t k = 0; k < pinned_.size(); ++k)
    force_[static_cast<std::size_t>(pinned_[k])] = pin_force_[k];
  for (auto& f : flow_.force()) f.fill(0);
  boundary_.spread(force_, flow_.force());
}

template <int D>
void Coupling<D>::push(double dt) {
  report_ = {};
  const double ahead = scheme_ == Scheme::explicit_euler ? 0 : 0.5 * dt;
  for (std::size_t i = 0; i < middle_.size(); ++i)
    middle_[i] = cloth_.position[i] + ahead * cloth_.velocity[i];
  boundary_.place(middle_);
  if (scheme_ == Scheme::implicit || !pinned_.empty()) find_water(dt);
  find_pins(dt);
  find_inertia();
  switch (scheme_) {
    case Scheme::implicit:
      solve(dt);
      break;
    case Scheme::explicit_euler:
      find_elastic(cloth_.position);
      break;
    case Scheme::broyden:
      start_iteration(dt);
      break;
  }
  spread_force();
}

template <int D>
void Coupling<D>::measure_strain() {
  for (const auto& g : cloth_.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto piece = std::span<const Vec<D>>(next_).subspan(
          static_cast<std::size_t>(g.node(p, 0)), static_cast<std::size_t>(g.sheet.nodes()));
      report_.largest_strain = std::max(report_.largest_strain, g.sheet.largest_strain(piece));
    }
}

template <int D>
typename Coupling<D>::Report Coupling<D>::move(double dt) {
  boundary_.interpolate(flow_.velocity(), water_);
  if (scheme_ == Scheme::explicit_euler)
    for (std::size_t i = 0; i < next_.size(); ++i) next_[i] = cloth_.position[i] + dt * water_[i];
  for (const int node : pinned_)
    next_[static_cast<std::size_t>(node)] = cloth_.position[static_cast<std::size_t>(node)];
  if (scheme_ != Scheme::implicit) measure_strain();
  report_.barrier = barrier_.accept(next_, dt);
  report_.barrier.touched += static_cast<int>(held_.size());
  cloth_.velocity_before = cloth_.velocity;
  for (std::size_t i = 0; i < next_.size(); ++i) {
    cloth_.velocity[i] = (next_[i] - cloth_.position[i]) / dt;
    cloth_.position[i] = next_[i];
  }
  measure_slip();
  last_step_ = dt;
  return report_;
}

/// How the nodes move past the water.
template <int D>
void Coupling<D>::measure_slip() {
  double leak = 0, slip = 0;
  for (const int node : pinned_) leak += water_[static_cast<std::size_t>(node)].squaredNorm();
  for (const int node : pinned_) water_[static_cast<std::size_t>(node)].setZero();
  for (std::size_t i = 0; i < next_.size(); ++i) {
    const double s = (cloth_.velocity[i] - water_[i]).norm();
    slip += s * s;
    report_.largest_slip = std::max(report_.largest_slip, s);
  }
  const auto pins = static_cast<double>(pinned_.size());
  const auto loose = static_cast<double>(next_.size()) - pins;
  report_.leak = std::sqrt(leak / std::max(pins, 1.0));
  report_.slip = std::sqrt(slip / std::max(loose, 1.0));
}

template class Coupling<2>;
template class Coupling<3>;

}  // namespace washtub
