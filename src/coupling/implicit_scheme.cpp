#include "coupling/implicit_scheme.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace washtub {
namespace {

// Tight enough that the result does not depend on which pieces are solved side by side.
constexpr double solve_tolerance = 1e-10;  // in node spacings
constexpr double light = 0.1;  // excess mass per ghost mass up to which inertia may lag a step
constexpr int rounds = 8;      // of looking for what has to be held

template <int D>
std::vector<double> solid_friction(const Cloth<D>& cloth) {
  std::vector<double> friction;
  for (const auto& g : cloth.groups)
    friction.insert(friction.end(), static_cast<std::size_t>(g.nodes()),
                    g.sheet.material.solid_friction);
  return friction;
}

}  // namespace

template <int D>
ImplicitScheme<D>::ImplicitScheme(CoupledStep<D>& step, Barrier<D>& barrier, Contact<D>* contact)
    : step_(step),
      barrier_(barrier),
      solids_(barrier, solid_friction(step.cloth)),
      contact_(contact),
      stale_(step.cloth.pieces(), 0) {
  const auto& parallel = step.flow.grid().parallel();
  for (const auto& g : step.cloth.groups) {
    solvers_.push_back(std::make_unique<ClothSolver<D>>(g.sheet, g.pinned, solve_tolerance));
    auto& mine = mine_.emplace_back();
    for (int p = 0; p < g.pieces; ++p) {
      if ((g.first_piece + p) % parallel.size() == parallel.rank()) mine.push_back(p);
      piece_.insert(piece_.end(), g.sheet.nodes(), g.first_piece + p);
    }
  }
  for (auto* n : {&free_, &push_, &target_}) n->resize(piece_.size(), Vec<D>::Zero());
  for (auto* m : {&inertia_, &yield_, &stiffness_}) m->resize(piece_.size());
  pushed_.resize(piece_.size(), 0);
}

/// Whether the inertia of a node has to be taken at the new time.
template <int D>
bool ImplicitScheme<D>::heavy(std::size_t node) const {
  const double dt = step_.dt();
  return step_.inertia.mass(static_cast<int>(node)) * step_.yield(node).diagonal().maxCoeff() >
         light * dt * dt;
}

/// Y = argmin sum m_i/(2 dt^2) |Y - Z|^2 + W(Y), with the inertia of heavy cloth inside.
template <int D>
void ImplicitScheme<D>::push() {
  step_.inertia.find_lagging(step_.flow.step_before());
  find_targets();
  for (std::size_t g = 0; g < mine_.size(); ++g) solve_group(g, mine_[g]);
  hold_off();
  for (std::size_t g = 0; g < mine_.size(); ++g) share_among_ranks(g, step_.cloth.elastic);
  for (int i = 0; i < step_.cloth.nodes(); ++i) {
    if (!heavy(static_cast<std::size_t>(i))) continue;
    for (int c = 0; c < D; ++c) step_.inertia.find(i, c, step_.next, step_.dt());
  }
  step_.add_up_force();
  add_reactions();
}

/// Where a node goes if nothing holds it, and how firmly.
template <int D>
void ImplicitScheme<D>::find_target(std::size_t i) {
  const double dt = step_.dt();
  const auto &x = step_.cloth.position[i], &v = step_.cloth.velocity[i];
  const Vec<D> water =
      x + dt * step_.water[i] - dt * dt * step_.mobility[i].cwiseProduct(step_.force[i]);
  yield_[i] = step_.yield(i);
  inertia_[i] = yield_[i].inverse();
  Vec<D> pull = inertia_[i] * water + step_.given[i];
  if (heavy(i)) {
    const double extra = step_.inertia.mass(static_cast<int>(i)) / (dt * dt);
    pull += extra * (x + dt * v);
    inertia_[i].diagonal().array() += extra;
    yield_[i] = inertia_[i].inverse();
  } else {
    pull += step_.inertia.force()[i];
  }
  free_[i] = yield_[i] * pull;
}

template <int D>
void ImplicitScheme<D>::find_targets() {
  for (std::size_t i = 0; i < free_.size(); ++i) find_target(i);
  stiffness_ = inertia_;
  std::fill(push_.begin(), push_.end(), Vec<D>::Zero());
  target_ = free_;
  for (const int node : step_.pinned) target_[node] = step_.cloth.position[node];
}

template <int D>
void ImplicitScheme<D>::solve_group(std::size_t g, const std::vector<int>& pieces) {
  const auto& group = step_.cloth.groups[g];
  const auto first = static_cast<std::size_t>(group.first_node);
  const auto n = static_cast<std::size_t>(group.nodes());
  const auto own = [&](auto& nodes) { return std::span(nodes).subspan(first, n); };
  const auto found = solvers_[g]->solve(
      pieces, {own(stiffness_), own(target_), own(step_.cloth.position), step_.dt()},
      own(step_.next), own(step_.cloth.elastic));
  const auto& parallel = step_.flow.grid().parallel();
  const double failed = parallel.max(found.failed >= 0 ? group.first_piece + found.failed : -1);
  if (failed >= 0)
    throw RunError("piece " + std::to_string(static_cast<int>(failed) + 1) +
                   ": the implicit solve did not converge; try a smaller time.step or time.cfl");
  auto& report = step_.report;
  report.iterations = std::max(report.iterations, static_cast<int>(parallel.max(found.iterations)));
  report.largest_strain = std::max(report.largest_strain, parallel.max(found.largest_strain));
  share_among_ranks(g, step_.next);
}

/// Every rank gets the values of the pieces that the others solved.
template <int D>
void ImplicitScheme<D>::share_among_ranks(std::size_t g, Nodes& values) {
  const auto& parallel = step_.flow.grid().parallel();
  if (parallel.size() == 1) return;
  const auto& group = step_.cloth.groups[g];
  for (int p = 0; p < group.pieces; ++p)
    if ((group.first_piece + p) % parallel.size() != parallel.rank())
      std::fill_n(values.begin() + group.node(p, 0), group.sheet.nodes(), Vec<D>::Zero());
  parallel.sum(std::span<double>(values[group.first_node].data(),
                                 static_cast<std::size_t>(group.nodes()) * D));
}

/// Looks for what has come too near to something, holds it off, and solves its pieces again, until
/// nothing is left to hold.
template <int D>
void ImplicitScheme<D>::hold_off() {
  solids_.start();
  if (contact_) contact_->start();
  for (int round = 0; round < rounds; ++round) {
    std::fill(pushed_.begin(), pushed_.end(), 0);
    HeldStep<D> step{step_.dt(), step_.cloth.position, step_.next, yield_, push_, pushed_};
    solids_.hold(step);
    if (contact_) {
      const InPhase touching(step_.clock, Phase::contact);
      contact_->hold(step);
    }
    if (!bind_pushed()) break;
    solve_again();
  }
  solids_.end(step_.next);
  step_.report.barrier.touched = solids_.count();
}

/// Stiffness and target of the nodes whose hold has changed; false if there are none.
template <int D>
bool ImplicitScheme<D>::bind_pushed() {
  std::fill(stale_.begin(), stale_.end(), 0);
  bool any = false;
  for (int i = 0; i < step_.cloth.nodes(); ++i) {
    if (!pushed_[i]) continue;
    stiffness_[i] = inertia_[i];
    Vec<D> pull = inertia_[i] * free_[i] + push_[i];
    solids_.add(i, stiffness_[i], pull);
    target_[i] = stiffness_[i].inverse() * pull;
    stale_[piece_[i]] = 1;
    any = true;
  }
  for (const int node : step_.pinned) target_[node] = step_.cloth.position[node];
  return any;
}

template <int D>
void ImplicitScheme<D>::solve_again() {
  for (std::size_t g = 0; g < mine_.size(); ++g) {
    const auto& group = step_.cloth.groups[g];
    const auto first = stale_.begin() + group.first_piece;
    if (std::find(first, first + group.pieces, 1) == first + group.pieces) continue;
    pieces_.clear();
    std::copy_if(mine_[g].begin(), mine_[g].end(), std::back_inserter(pieces_),
                 [&](int p) { return first[p] != 0; });
    solve_group(g, pieces_);
  }
}

template <int D>
void ImplicitScheme<D>::add_reactions() {
  for (std::size_t i = 0; i < push_.size(); ++i) step_.force[i] += push_[i];
  solids_.for_forces([&](int node, int, const Vec<D>& force) { step_.force[node] += force; });
}

template <int D>
double ImplicitScheme<D>::contact_moment(int solid, const Vec<3>& axis) const {
  double moment = 0;
  solids_.for_forces([&](int node, int surface, const Vec<D>& force) {
    if (surface != solid) return;
    const Vec<D> x = barrier_.inside(step_.next[node]);
    moment -= (x[0] - axis[0]) * force[1] - (x[1] - axis[1]) * force[0];
  });
  return moment;
}

template class ImplicitScheme<2>;
template class ImplicitScheme<3>;

}  // namespace washtub
