#include "coupling/implicit_scheme.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace washtub {
namespace {

// Tight enough that the result does not depend on which pieces are solved side by side.
constexpr double solve_tolerance = 1e-10;  // in node spacings
constexpr double light = 0.1;  // excess mass per ghost mass up to which inertia may lag a step
constexpr double grip = 1e4;   // stiffness of a held node over that of a free one
constexpr double held_close = 1e-2;  // of the shortest cell edge: a held node is where it should be
constexpr int rounds = 4;            // of looking for nodes that have to be held

}  // namespace

template <int D>
ImplicitScheme<D>::ImplicitScheme(CoupledStep<D>& step, Barrier<D>& barrier)
    : step_(step), barrier_(barrier), stale_(step.cloth.pieces(), 0) {
  const auto& parallel = step.flow.grid().parallel();
  for (const auto& g : step.cloth.groups) {
    solvers_.push_back(std::make_unique<ClothSolver<D>>(g.sheet, g.pinned, solve_tolerance));
    auto& mine = mine_.emplace_back();
    for (int p = 0; p < g.pieces; ++p) {
      if ((g.first_piece + p) % parallel.size() == parallel.rank()) mine.push_back(p);
      piece_.insert(piece_.end(), g.sheet.nodes(), g.first_piece + p);
    }
  }
  for (auto* n : {&stiffness_, &free_, &target_, &reaction_})
    n->resize(piece_.size(), Vec<D>::Zero());
  held_by_.resize(piece_.size(), not_held);
}

/// Whether the inertia of a node has to be taken at the new time.
template <int D>
bool ImplicitScheme<D>::heavy(int node, int component) const {
  return step_.excess.mass(node) * step_.mobility[node][component] > light;
}

/// Y = argmin sum m_i/(2 dt^2) |Y - Z|^2 + W(Y), with the inertia of heavy cloth inside.
template <int D>
void ImplicitScheme<D>::push() {
  step_.excess.find_lagging(step_.flow.step_before());
  find_targets();
  for (std::size_t g = 0; g < mine_.size(); ++g) solve_group(g, mine_[g]);
  keep_out();
  step_.find_elastic(step_.next);
  for (int i = 0; i < step_.cloth.nodes(); ++i)
    for (int c = 0; c < D; ++c)
      if (heavy(i, c)) step_.excess.find(i, c, step_.next, step_.dt());
  step_.add_up_force();
  add_reactions();
}

template <int D>
void ImplicitScheme<D>::find_targets() {
  const double dt = step_.dt();
  const auto &position = step_.cloth.position, &velocity = step_.cloth.velocity;
  for (int i = 0; i < step_.cloth.nodes(); ++i)
    for (int c = 0; c < D; ++c) {
      const double m = 1 / step_.mobility[i][c], x = position[i][c];
      const double free = x + dt * step_.water[i][c];
      const double extra = heavy(i, c) ? step_.excess.mass(i) : 0;
      const double e = extra > 0 ? step_.excess.weight(i, c) : step_.excess.force()[i][c];
      const double push = dt * dt / m * (e - step_.force[i][c]);
      stiffness_[i][c] = (m + extra) / (dt * dt);
      target_[i][c] = (m * (free + push) + extra * (x + dt * velocity[i][c])) / (m + extra);
    }
  free_ = target_;
  for (const int node : step_.pinned) target_[node] = position[node];
}

template <int D>
void ImplicitScheme<D>::solve_group(std::size_t g, const std::vector<int>& pieces) {
  const auto& group = step_.cloth.groups[g];
  const auto first = static_cast<std::size_t>(group.first_node);
  const auto n = static_cast<std::size_t>(group.nodes());
  const auto found = solvers_[g]->solve(
      pieces, std::span<const Vec<D>>(stiffness_).subspan(first, n),
      std::span<const Vec<D>>(target_).subspan(first, n), std::span(step_.next).subspan(first, n));
  const auto& parallel = step_.flow.grid().parallel();
  const double failed = parallel.max(found.failed >= 0 ? group.first_piece + found.failed : -1);
  if (failed >= 0)
    throw RunError("piece " + std::to_string(static_cast<int>(failed) + 1) +
                   ": the implicit solve did not converge; try a smaller time.step or time.cfl");
  auto& report = step_.report;
  report.iterations = std::max(report.iterations, static_cast<int>(parallel.max(found.iterations)));
  report.largest_strain = std::max(report.largest_strain, parallel.max(found.largest_strain));
  share_among_ranks(g);
}

/// Every rank gets the places of the pieces that the others solved.
template <int D>
void ImplicitScheme<D>::share_among_ranks(std::size_t g) {
  const auto& parallel = step_.flow.grid().parallel();
  if (parallel.size() == 1) return;
  const auto& group = step_.cloth.groups[g];
  for (int p = 0; p < group.pieces; ++p)
    if ((group.first_piece + p) % parallel.size() != parallel.rank())
      std::fill_n(step_.next.begin() + group.node(p, 0), group.sheet.nodes(), Vec<D>::Zero());
  parallel.sum(std::span<double>(step_.next[group.first_node].data(),
                                 static_cast<std::size_t>(group.nodes()) * D));
}

/// Nodes that the solve put too near a surface are held at the nearest allowed place, and their
/// pieces solved again, until none is left.
template <int D>
void ImplicitScheme<D>::keep_out() {
  for (const int node : held_) held_by_[node] = not_held;
  held_.clear();
  for (int round = 0; round < rounds && hold_contacts(); ++round) solve_again();
  step_.report.barrier.touched = static_cast<int>(held_.size());
}

/// Holds the nodes that are too near; false if all of them are where they are held already.
template <int D>
bool ImplicitScheme<D>::hold_contacts() {
  const double close = held_close * step_.flow.grid().mesh().h.minCoeff();
  std::fill(stale_.begin(), stale_.end(), 0);
  bool any = false;
  for (const auto& contact : barrier_.find(step_.next, step_.dt())) {
    const int i = contact.node;
    if (held_by_[i] != not_held && (contact.to - step_.next[i]).norm() < close) continue;
    if (held_by_[i] == not_held) {
      held_.push_back(i);
      stiffness_[i] *= grip;
    }
    held_by_[i] = contact.solid;
    target_[i] = contact.to;
    stale_[piece_[i]] = 1;
    any = true;
  }
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

/// What holds a node: m_i (Y - Z)/dt^2 less the elastic force.
template <int D>
void ImplicitScheme<D>::add_reactions() {
  for (const int i : held_) {
    reaction_[i] =
        (stiffness_[i] / grip).cwiseProduct(step_.next[i] - free_[i]) - step_.cloth.elastic[i];
    step_.force[i] += reaction_[i];
  }
}

template <int D>
double ImplicitScheme<D>::contact_moment(int solid, const Vec<3>& axis) const {
  double moment = 0;
  for (const int i : held_) {
    if (held_by_[i] != solid) continue;
    const Vec<D> x = barrier_.inside(step_.next[i]);
    moment -= (x[0] - axis[0]) * reaction_[i][1] - (x[1] - axis[1]) * reaction_[i][0];
  }
  return moment;
}

template class ImplicitScheme<2>;
template class ImplicitScheme<3>;

}  // namespace washtub
