#include "coupling/coupling.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.hpp"

namespace washtub {
namespace {

// Tight enough that the result does not depend on which pieces are solved side by side.
constexpr double solve_tolerance = 1e-10;  // in node spacings
constexpr int not_held = -2;
constexpr double grip = 1e4;         // stiffness of a held node over that of a free one
constexpr double held_close = 1e-2;  // of the shortest cell edge: a held node is where it should be
constexpr int rounds = 4;            // of looking for nodes that have to be held
constexpr double light = 0.1;  // excess mass per ghost mass up to which inertia may lag a step

}  // namespace

template <int D>
Coupling<D>::Coupling(Flow<D>& flow, Cloth<D>& cloth, const DomainMapping<D>& mapping,
                      Kernel kernel, const typename ImmersedBoundary<D>::Reflections& sides,
                      Scheme scheme, double marker_spacing)
    : flow_(flow),
      cloth_(cloth),
      mapping_(mapping),
      scheme_(scheme),
      boundary_(flow.grid(), cloth, kernel, sides, marker_spacing),
      barrier_(flow.grid(), mapping, cloth.position) {
  const auto& parallel = flow.grid().parallel();
  for (const auto& g : cloth.groups) {
    solvers_.push_back(
        std::make_unique<ClothSolver<D>>(g.sheet, std::vector<int>{}, solve_tolerance));
    auto& mine = mine_.emplace_back();
    for (int p = 0; p < g.pieces; ++p) {
      if ((g.first_piece + p) % parallel.size() == parallel.rank()) mine.push_back(p);
      for (const double area : g.sheet.area) excess_.push_back(g.sheet.material.excess_mass * area);
    }
  }
  for (auto& f : provisional_) f = flow.grid().make_field();
  for (auto* n : {&next_, &middle_, &target_, &stiffness_, &mobility_, &carried_, &water_, &free_,
                  &reaction_, &force_})
    n->resize(cloth.position.size(), Vec<D>::Zero());
  held_by_.resize(cloth.position.size(), not_held);
}

/// Inertia of the mass beyond that of the displaced water, from the last two steps.
template <int D>
void Coupling<D>::find_inertia() {
  for (std::size_t i = 0; i < carried_.size(); ++i)
    carried_[i] =
        last_step_ > 0
            ? Vec<D>(-excess_[i] / last_step_ * (cloth_.velocity[i] - cloth_.velocity_before[i]))
            : Vec<D>(Vec<D>::Zero());
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
  flow_.provisional(dt, provisional_);
  boundary_.mobility(flow_.openings(), flow_.density(), mobility_);
  boundary_.interpolate(provisional_, water_);
  for (std::size_t i = 0; i < target_.size(); ++i) {
    const Vec<D>& x = cloth_.position[i];
    for (int c = 0; c < D; ++c) {
      const double m = 1 / mobility_[i][c];
      const double free = x[c] + dt * water_[i][c];
      const bool heavy = excess_[i] > light * m;
      if (heavy) carried_[i][c] = 0;
      const double push = dt * dt / m * (carried_[i][c] - force_[i][c]);
      const double extra = heavy ? excess_[i] : 0;
      stiffness_[i][c] = (m + extra) / (dt * dt);
      target_[i][c] =
          (m * (free + push) + extra * (x[c] + dt * cloth_.velocity[i][c])) / (m + extra);
    }
  }
  free_ = target_;
  for (std::size_t g = 0; g < cloth_.groups.size(); ++g) solve_group(g, mine_[g]);
  keep_out(dt);
  find_elastic(next_);
  for (std::size_t i = 0; i < target_.size(); ++i)
    for (int c = 0; c < D; ++c)
      if (excess_[i] * mobility_[i][c] > light)
        carried_[i][c] = -excess_[i] / (dt * dt) *
                         (next_[i][c] - cloth_.position[i][c] - dt * cloth_.velocity[i][c]);
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

template <int D>
void Coupling<D>::push(double dt) {
  report_ = {};
  find_inertia();
  const double ahead = scheme_ == Scheme::implicit ? 0.5 * dt : 0;
  for (std::size_t i = 0; i < middle_.size(); ++i)
    middle_[i] = cloth_.position[i] + ahead * cloth_.velocity[i];
  boundary_.place(middle_);
  if (scheme_ == Scheme::implicit)
    solve(dt);
  else
    find_elastic(cloth_.position);
  for (std::size_t i = 0; i < force_.size(); ++i) force_[i] = cloth_.elastic[i] + carried_[i];
  add_reactions();
  for (auto& f : flow_.force()) f.fill(0);
  boundary_.spread(force_, flow_.force());
}

template <int D>
typename Coupling<D>::Report Coupling<D>::move(double dt) {
  boundary_.interpolate(flow_.velocity(), water_);
  if (scheme_ == Scheme::explicit_euler) {
    for (std::size_t i = 0; i < next_.size(); ++i) next_[i] = cloth_.position[i] + dt * water_[i];
    for (const auto& g : cloth_.groups)
      for (int p = 0; p < g.pieces; ++p)
        report_.largest_strain = std::max(
            report_.largest_strain, g.sheet.largest_strain(std::span<const Vec<D>>(next_).subspan(
                                        static_cast<std::size_t>(g.node(p, 0)),
                                        static_cast<std::size_t>(g.sheet.nodes()))));
  }
  report_.barrier = barrier_.accept(next_, dt);
  report_.barrier.touched += static_cast<int>(held_.size());
  cloth_.velocity_before = cloth_.velocity;
  double squares = 0;
  for (std::size_t i = 0; i < next_.size(); ++i) {
    cloth_.velocity[i] = (next_[i] - cloth_.position[i]) / dt;
    cloth_.position[i] = next_[i];
    const double slip = (cloth_.velocity[i] - water_[i]).norm();
    squares += slip * slip;
    report_.largest_slip = std::max(report_.largest_slip, slip);
  }
  report_.slip = std::sqrt(squares / static_cast<double>(next_.size()));
  last_step_ = dt;
  return report_;
}

template class Coupling<2>;
template class Coupling<3>;

}  // namespace washtub
