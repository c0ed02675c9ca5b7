#include <algorithm>
#include <string>

#include "base/error.hpp"
#include "coupling/coupling.hpp"

namespace washtub {
namespace {

constexpr double grip = 1e4;         // stiffness of a held node over that of a free one
constexpr double held_close = 1e-2;  // of the shortest cell edge: a held node is where it should be
constexpr int rounds = 4;            // of looking for nodes that have to be held

}  // namespace

/// Every rank gets the values of the pieces that the others solved.
template <int D>
void Coupling<D>::share_among_ranks(Nodes& values, std::size_t g) const {
  const auto& parallel = flow_.grid().parallel();
  if (parallel.size() == 1) return;
  const auto& group = cloth_.groups[g];
  for (int p = 0; p < group.pieces; ++p)
    if ((group.first_piece + p) % parallel.size() != parallel.rank())
      std::fill_n(values.begin() + group.node(p, 0), group.sheet.nodes(), Vec<D>::Zero());
  parallel.sum(std::span<double>(values[static_cast<std::size_t>(group.first_node)].data(),
                                 static_cast<std::size_t>(group.nodes()) * D));
}

template <int D>
void Coupling<D>::solve_group(std::size_t g, const std::vector<int>& pieces) {
  const auto& group = cloth_.groups[g];
  const auto first = static_cast<std::size_t>(group.first_node);
  const auto n = static_cast<std::size_t>(group.nodes());
  const auto report = solvers_[g]->solve(
      pieces, std::span<const Vec<D>>(stiffness_).subspan(first, n),
      std::span<const Vec<D>>(target_).subspan(first, n), std::span(next_).subspan(first, n));
  const auto& parallel = flow_.grid().parallel();
  const double failed = parallel.max(report.failed >= 0 ? group.first_piece + report.failed : -1);
  if (failed >= 0)
    throw RunError("piece " + std::to_string(static_cast<int>(failed) + 1) +
                   ": the implicit solve did not converge; try a smaller time.step or time.cfl");
  report_.iterations =
      std::max(report_.iterations, static_cast<int>(parallel.max(report.iterations)));
  report_.largest_strain = std::max(report_.largest_strain, parallel.max(report.largest_strain));
  share_among_ranks(next_, g);
}

/// Y = argmin sum m_i/(2 dt^2) |Y - Z|^2 + W(Y), with the inertia of heavy cloth inside.
template <int D>
void Coupling<D>::solve(double dt) {
  for (std::size_t i = 0; i < target_.size(); ++i) {
    const Vec<D>& x = cloth_.position[i];
    for (int c = 0; c < D; ++c) {
      const double m = 1 / mobility_[i][c];
      const double free = x[c] + dt * water_[i][c];
      const double extra = heavy(i, c) ? excess_[i] : 0;
      if (extra > 0) carried_[i][c] = extra * gravity_[c];
      const double push = dt * dt / m * (carried_[i][c] - force_[i][c]);
      stiffness_[i][c] = (m + extra) / (dt * dt);
      target_[i][c] =
          (m * (free + push) + extra * (x[c] + dt * cloth_.velocity[i][c])) / (m + extra);
    }
  }
  free_ = target_;
  for (const int node : pinned_)
    target_[static_cast<std::size_t>(node)] = cloth_.position[static_cast<std::size_t>(node)];
  for (std::size_t g = 0; g < cloth_.groups.size(); ++g) solve_group(g, mine_[g]);
  keep_out(dt);
  find_elastic(next_);
  find_implicit_inertia(dt, false);
}

/// Nodes that the solve put too near a surface are held at the nearest allowed place, and their
/// pieces solved again, until none is left.
template <int D>
void Coupling<D>::keep_out(double dt) {
  for (const int i : held_) held_by_[static_cast<std::size_t>(i)] = not_held;
  held_.clear();
  const double close = held_close * flow_.grid().mesh().h.minCoeff();
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::vector<char>> again(cloth_.groups.size());
    bool any = false;
    for (const auto& contact : barrier_.find(next_, dt)) {
      const auto i = static_cast<std::size_t>(contact.node);
      if (held_by_[i] != not_held && (contact.to - next_[i]).norm() < close) continue;
      if (held_by_[i] == not_held) {
        held_.push_back(contact.node);
        stiffness_[i] *= grip;
      }
      held_by_[i] = contact.solid;
      target_[i] = contact.to;
      any = true;
      for (std::size_t g = 0; g < again.size(); ++g) {
        const auto& group = cloth_.groups[g];
        const int local = contact.node - group.first_node;
        if (local < 0 || local >= group.nodes()) continue;
        again[g].resize(static_cast<std::size_t>(group.pieces), 0);
        again[g][static_cast<std::size_t>(local / group.sheet.nodes())] = 1;
      }
    }
    if (!any) break;
    for (std::size_t g = 0; g < again.size(); ++g) {
      if (again[g].empty()) continue;
      std::vector<int> pieces;
      for (const int p : mine_[g])
        if (again[g][static_cast<std::size_t>(p)]) pieces.push_back(p);
      solve_group(g, pieces);
    }
  }
}

/// What holds a node: m_i (Y - Z)/dt^2 less the elastic force.
template <int D>
void Coupling<D>::add_reactions() {
  for (const int node : held_) {
    const auto i = static_cast<std::size_t>(node);
    reaction_[i] = (stiffness_[i] / grip).cwiseProduct(next_[i] - free_[i]) - cloth_.elastic[i];
    force_[i] += reaction_[i];
  }
}

template class Coupling<2>;
template class Coupling<3>;

}  // namespace washtub
