#include "coupling/coupled_step.hpp"

#include <algorithm>
#include <string>

namespace washtub {

template <int D>
CoupledStep<D>::CoupledStep(Flow<D>& flow_, Cloth<D>& cloth_, PhaseClock* clock_)
    : clock(clock_),
      flow(flow_),
      cloth(cloth_),
      surface(cloth_),
      inertia(cloth_),
      permeability(cloth_, surface) {
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p)
      for (const int node : g.pinned) pinned.push_back(g.node(p, node));
  for (auto* n : {&water, &mobility, &given, &force, &next})
    n->resize(cloth.position.size(), Vec<D>::Zero());
}

template <int D>
void CoupledStep<D>::find_elastic(const Nodes& X) {
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto first = static_cast<std::size_t>(g.node(p, 0));
      const auto n = static_cast<std::size_t>(g.sheet.nodes());
      g.sheet.force(std::span(X).subspan(first, n), std::span(cloth.elastic).subspan(first, n));
    }
}

template <int D>
void CoupledStep<D>::find_given(const Nodes& velocity) {
  work_before = work_of_given();
  time_given = dt();
  std::fill(given.begin(), given.end(), Vec<D>::Zero());
  carried = velocity;
  for (const int node : pinned) carried[node].setZero();
  for (const auto& f : forces) f->add({cloth.position, carried, dt()}, given);
}

template <int D>
double CoupledStep<D>::work_of_given() const {
  double power = 0;
  for (std::size_t i = 0; i < given.size(); ++i) power += given[i].dot(cloth.velocity[i]);
  return work_before + time_given * power;
}

template <int D>
void CoupledStep<D>::state(Archive& archive) {
  archive.same_length("force", force);
  archive.same_length("mobility", mobility);
  archive.same_length("given", given);
  archive.value("time given", time_given);
  archive.value("work before", work_before);
  for (std::size_t i = 0; i < forces.size(); ++i)
    archive.value("force " + std::to_string(i), *forces[i]);
}

template <int D>
void CoupledStep<D>::add_up_force() {
  for (std::size_t i = 0; i < force.size(); ++i)
    force[i] = cloth.elastic[i] + given[i] + inertia.force()[i];
}

template <int D>
Mat<D> CoupledStep<D>::yield(std::size_t node) const {
  Mat<D> ways = (dt() * dt() * mobility[node]).asDiagonal();
  if (permeability.any()) ways += dt() * permeability[node];
  return ways;
}

template <int D>
void CoupledStep<D>::measure_strain() {
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto piece = std::span<const Vec<D>>(next).subspan(
          static_cast<std::size_t>(g.node(p, 0)), static_cast<std::size_t>(g.sheet.nodes()));
      report.largest_strain = std::max(report.largest_strain, g.sheet.largest_strain(piece));
    }
}

template struct CoupledStep<2>;
template struct CoupledStep<3>;

}  // namespace washtub
