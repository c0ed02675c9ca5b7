#include "coupling/coupling.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "contact/repulsion.hpp"

namespace washtub {
namespace {

constexpr double moves_mobility = 0.25;  // cells that a node goes until it has another mobility

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(std::string("Coupling::") + what);
}

}  // namespace

template <int D>
Coupling<D>::Coupling(Flow<D>& flow, Cloth<D>& cloth, const DomainMapping<D>& mapping,
                      Kernel kernel, const SidePairs<D>& sides, Scheme scheme,
                      double marker_spacing, PhaseClock* clock, const ContactSettings& contact)
    : mapping_(mapping),
      step_(flow, cloth, clock),
      boundary_(flow.grid(), cloth, kernel, sides, marker_spacing),
      barrier_(flow.grid(), mapping, cloth, contact.solid_time),
      middle_(cloth.position.size()),
      place_of_mobility_(cloth.position.size(), Vec<D>::Zero()),
      pin_force_(step_.pinned.size()) {
  if (contact.scheme == ContactScheme::layers) {
    const auto& mesh = flow.grid().mesh();
    const auto& parallel = flow.grid().parallel();
    contact_.emplace(step_.surface, cloth, mesh, parallel, contact);
    add(std::make_unique<Repulsion<D>>(step_.surface, mesh, parallel, contact,
                                       friction_of_groups(cloth)));
  }
  scheme_ = make_scheme(scheme, step_, barrier_, contact_ ? &*contact_ : nullptr);
}

/// Whether the nodes are where they were, within a part of a cell, when the mobility was found.
template <int D>
bool Coupling<D>::mobility_holds() const {
  if (age_of_mobility_ >= lifetime_of_mobility) return false;
  const Vec<D> most = moves_mobility * step_.flow.grid().mesh().h;
  for (std::size_t i = 0; i < middle_.size(); ++i)
    if (((middle_[i] - place_of_mobility_[i]).cwiseAbs() - most).maxCoeff() > 0) return false;
  return true;
}

/// Where the water would carry the nodes, and how easily it is moved there. The latter weighs how
/// the force changes within a step, so that its error is one of the order of the step.
template <int D>
void Coupling<D>::find_water() {
  const auto& flow = step_.flow;
  if (!mobility_holds()) {
    boundary_.mobility(flow.openings(), flow.density(), step_.mobility);
    place_of_mobility_ = middle_;
    age_of_mobility_ = 0;
  }
  ++age_of_mobility_;
  boundary_.interpolate(flow.provisional(), step_.water);
}

template <int D>
void Coupling<D>::find_pins() {
  for (std::size_t k = 0; k < pin_force_.size(); ++k) {
    const auto i = static_cast<std::size_t>(step_.pinned[k]);
    const Vec<D> way = step_.dt() * step_.water[i] -
                       step_.dt() * step_.dt() * step_.mobility[i].cwiseProduct(step_.force[i]);
    pin_force_[k] = -step_.yield(i).inverse() * way;
  }
}

/// Velocity of the projected water at the nodes, and of cloth that it goes through past it.
template <int D>
void Coupling<D>::find_velocity() {
  const InPhase interpolating(step_.clock, Phase::exchange);
  boundary_.interpolate(step_.flow.velocity(), step_.water);
  if (step_.permeability.any())
    for (std::size_t i = 0; i < step_.water.size(); ++i)
      step_.water[i] += step_.permeability[i] * step_.force[i];
  double leak = 0;
  for (const int node : step_.pinned) leak += step_.water[node].squaredNorm();
  for (const int node : step_.pinned) step_.water[node].setZero();
  step_.report.leak = std::sqrt(leak / std::max(static_cast<double>(step_.pinned.size()), 1.0));
}

/// Spreads the total force of the nodes.
template <int D>
void Coupling<D>::spread_force() {
  for (std::size_t k = 0; k < pin_force_.size(); ++k) step_.force[step_.pinned[k]] = pin_force_[k];
  auto& f = step_.flow.force();
  for (auto& component : f) component.fill(0);
  boundary_.spread(step_.force, f);
}

template <int D>
void Coupling<D>::push() {
  require(stage_ == Stage::moved, "push(): the last step waits for move()");
  require(step_.flow.predicted(), "push(): only between Flow::predict() and Flow::project()");
  step_.report = {};
  const double ahead = scheme_->ahead() * step_.dt();
  for (std::size_t i = 0; i < middle_.size(); ++i)
    middle_[i] = step_.cloth.position[i] + ahead * step_.cloth.velocity[i];
  boundary_.place(middle_);
  if (scheme_->needs_provisional() || !step_.pinned.empty()) find_water();
  step_.permeability.find(step_.cloth.position);
  find_pins();
  {
    const InPhase touching(step_.clock, Phase::contact);
    step_.find_given(scheme_->needs_provisional() ? step_.water : step_.cloth.velocity);
  }
  {
    const InPhase solving(step_.clock, Phase::cloth);
    scheme_->push();
  }
  spread_force();
  stage_ = Stage::pushed;
}

template <int D>
bool Coupling<D>::again() {
  require(stage_ == Stage::pushed && !step_.flow.predicted(),
          "again(): only after push() and Flow::project()");
  if (scheme_->needs_projected()) find_velocity();
  const InPhase solving(step_.clock, Phase::cloth);
  if (scheme_->again()) {
    const InPhase spreading(step_.clock, Phase::exchange);
    spread_force();
    return true;
  }
  stage_ = Stage::settled;
  return false;
}

template <int D>
typename Coupling<D>::Report Coupling<D>::move(bool measure_slip) {
  require(stage_ == Stage::settled, "move(): only once again() is false");
  auto& cloth = step_.cloth;
  auto& next = step_.next;
  auto& report = step_.report;
  const double dt = step_.dt();
  const InPhase moving(step_.clock, Phase::cloth);
  scheme_->move();
  for (const int node : step_.pinned) next[node] = cloth.position[node];
  const int held = report.barrier.touched;  // by the scheme
  report.barrier = barrier_.accept(next, dt);
  report.barrier.touched += held;
  if (contact_) {
    const InPhase touching(step_.clock, Phase::contact);
    report.contact = contact_->end(cloth.position, next);
  }
  cloth.velocity_before = cloth.velocity;
  for (std::size_t i = 0; i < next.size(); ++i) {
    cloth.velocity[i] = (next[i] - cloth.position[i]) / dt;
    cloth.position[i] = next[i];
  }
  if (measure_slip && !scheme_->needs_projected()) find_velocity();
  if (measure_slip || scheme_->needs_projected()) this->measure_slip();
  stage_ = Stage::moved;
  return report;
}

/// How the nodes move past the water.
template <int D>
void Coupling<D>::measure_slip() {
  double squares = 0;
  for (std::size_t i = 0; i < step_.water.size(); ++i) {
    const double s = (step_.cloth.velocity[i] - step_.water[i]).norm();
    squares += s * s;
  }
  const auto loose = static_cast<double>(step_.water.size() - step_.pinned.size());
  step_.report.slip = std::sqrt(squares / std::max(loose, 1.0));
  step_.report.looked = true;
}

template <int D>
double Coupling<D>::contact_moment(std::size_t solid) const {
  return scheme_->contact_moment(static_cast<int>(solid), mapping_.solids()[solid].centre);
}

template class Coupling<2>;
template class Coupling<3>;

}  // namespace washtub
