#include "record/observer.hpp"

#include <algorithm>
#include <numeric>

#include "cloth/thread.hpp"
#include "measure/cycles.hpp"

namespace washtub {

namespace {

/// (x, y) of the axis of the first solid that turns; the origin where none does.
Vec<2> turning_axis(const std::vector<Solid>& solids) {
  for (const auto& s : solids)
    if (s.drive.moving()) return s.centre.head<2>();
  return Vec<2>::Zero();
}

}  // namespace

bool is_ring(const Sheet<2>& sheet) { return sheet.closed[1] && sheet.period[1].isZero(); }

template <int D>
Observer<D>::Observer(Simulation<D>& simulation)
    : simulation_(simulation),
      window_{simulation.definition().output.window_begin,
              simulation.definition().output.window_end},
      axis_(turning_axis(simulation.mapping().solids())),
      stress_(static_cast<std::size_t>(simulation.cloth().pieces()), window_),
      scatter_(static_cast<std::size_t>(simulation.cloth().pieces()), window_, axis_),
      cycles_(whole_cycles(window_, window_.end, simulation.definition().scale.period)) {
  if (simulation.definition().exact) exact_.emplace(*simulation.definition().exact);
  const auto n = simulation.cloth().position.size();
  for (auto* v : {&membrane_, &bending_, &total_}) v->resize(n);
}

template <int D>
void Observer<D>::observe_solids(Sample& sample) {
  const auto& solids = simulation_.mapping().solids();
  for (std::size_t s = 0; s < solids.size(); ++s) {
    const auto loads = simulation_.loads(s);
    SolidSample solid;
    solid.angle = solids[s].drive.angle(sample.time);
    solid.friction = loads.friction.torque;
    solid.pressure = loads.pressure.torque;
    solid.convection = loads.convection.torque;
    solid.torque = loads.total().torque;
    solid.force.head<D>() = loads.total().force;
    if (solids[s].drive.moving()) {
      const Impulse since = simulation_.take_impulse(s);
      if (since.time > 0) {
        solid.speed = since.angle / since.time;
        solid.torque = since.moment / since.time;
      }
    }
    sample.solids.push_back(solid);
  }
}

/// Cycles begin as time goes on; a sample counts for the last ones only.
template <int D>
void Observer<D>::observe_scatter(const Interval& since) {
  const auto& cloth = simulation_.cloth();
  for (auto next = scatter_of_cycles_.size();
       next < cycles_.size() && cycles_[next].begin < since.end; ++next)
    scatter_of_cycles_.emplace_back(static_cast<std::size_t>(cloth.pieces()), cycles_[next], axis_);
  for (const auto& g : cloth.groups)
    for (int p = 0; p < g.pieces; ++p) {
      const auto X = cloth.piece(g, p);
      const auto piece = static_cast<std::size_t>(g.first_piece + p);
      scatter_.add<D>(since, piece, X, g.sheet.area);
      for (auto cycle = scatter_of_cycles_.rbegin();
           cycle != scatter_of_cycles_.rend() && cycle->window().end > since.begin; ++cycle)
        cycle->template add<D>(since, piece, X, g.sheet.area);
    }
}

template <int D>
void Observer<D>::observe_cloth(Sample& sample, const Interval& since) {
  const auto& cloth = simulation_.cloth();
  double area = 0;
  for (const auto& g : cloth.groups) {
    node_stress_.resize(static_cast<std::size_t>(g.sheet.nodes()));
    for (int p = 0; p < g.pieces; ++p) {
      const auto X = cloth.piece(g, p);
      const auto first = static_cast<std::size_t>(g.node(p, 0));
      find_stress(g.sheet, X, node_stress_);
      for (std::size_t i = 0; i < node_stress_.size(); ++i) {
        membrane_[first + i] = node_stress_[i].membrane;
        bending_[first + i] = node_stress_[i].bending;
        total_[first + i] = node_stress_[i].total;
      }
      const auto part = [&](const std::vector<double>& v) {
        return std::span(v).subspan(first, node_stress_.size());
      };
      sample.pieces.push_back(
          area_mean({part(membrane_), part(bending_), part(total_)}, g.sheet.area));
      sample.centres.push_back(radius_height<D>(centre_of_mass<D>(X, g.sheet.area), axis_));
      const double piece_area = std::accumulate(g.sheet.area.begin(), g.sheet.area.end(), 0.0);
      sample.centre += piece_area * sample.centres.back();
      area += piece_area;
    }
  }
  if (area > 0) sample.centre /= area;
  const double pieces = static_cast<double>(sample.pieces.size());
  for (const auto& p : sample.pieces) {
    sample.stress.membrane += p.membrane / pieces;
    sample.stress.bending += p.bending / pieces;
    sample.stress.total += p.total / pieces;
  }
  stress_.add(since, sample.pieces);
  observe_scatter(since);
}

template <int D>
void Observer<D>::observe_probes(Sample& sample) const {
  const auto& cloth = simulation_.cloth();
  for (const ProbeCase& probe : simulation_.definition().probes) {
    auto group = cloth.groups.begin();
    while (probe.piece > group->first_piece + group->pieces) ++group;
    // In 2-D the thread's nodes are counted along its second direction.
    const std::array<int, 2> nodes = {D == 3 ? group->sheet.extent[0] : group->sheet.extent[1],
                                      D == 3 ? group->sheet.extent[1] : 1};
    std::array<int, 2> node = {probe.node[0], D == 3 ? probe.node[1] : 0};
    for (std::size_t d = 0; d < 2; ++d)
      if (node[d] < 0) node[d] += nodes[d];
    const int i = group->node(probe.piece - 1 - group->first_piece, node[0] + nodes[0] * node[1]);
    sample.probes.push_back(Vec<3>::Zero());
    sample.probes.back().template head<D>() = cloth.position[static_cast<std::size_t>(i)];
  }
}

template <int D>
void Observer<D>::observe_rings(Sample& sample) const {
  if constexpr (D == 2) {
    const auto& cloth = simulation_.cloth();
    int rings = 0;
    for (const auto& g : cloth.groups) {
      if (!is_ring(g.sheet)) continue;
      for (int p = 0; p < g.pieces; ++p, ++rings)
        sample.enclosed_area += std::abs(enclosed_area(cloth.piece(g, p)));
    }
    if (rings > 0) sample.enclosed_area /= rings;
  }
}

template <int D>
const Sample& Observer<D>::observe() {
  Sample sample;
  sample.time = simulation_.time();
  const double before = samples_.empty() ? sample.time : samples_.back().time;
  observe_solids(sample);
  if (simulation_.cloth().pieces() > 0) observe_cloth(sample, {before, sample.time});
  observe_probes(sample);
  observe_rings(sample);
  if (exact_) sample.error = exact_->compare(simulation_);
  samples_.push_back(std::move(sample));
  return samples_.back();
}

template <int D>
void Observer<D>::watch(const typename Simulation<D>::Step& step) {
  auto& e = extremes_;
  e.divergence = std::max(e.divergence, step.divergence);
  e.courant = std::max(e.courant, step.courant);
  e.slip = std::max(e.slip, step.cloth.slip);
  const double share = step.speed > 0 ? step.cloth.slip / step.speed : 0;
  e.slip_share = std::max(e.slip_share, share);
  e.sum_of_slip_shares += share;
  e.penetration = std::max(e.penetration, step.cloth.barrier.penetration);
  e.strain = std::max(e.strain, step.cloth.largest_strain);
  e.touched += step.cloth.barrier.touched;
  e.cycles += step.pressure.cycles;
  e.newton += step.cloth.iterations;
  e.unconverged += !step.pressure.converged;
  e.largest_step = std::max(e.largest_step, step.dt);
  e.smallest_step = std::min(e.smallest_step, step.dt);
}

template <int D>
void Observer<D>::state(Archive& archive) {
  archive.value("stress", stress_);
  archive.value("scatter", scatter_);
}

template class Observer<2>;
template class Observer<3>;

}  // namespace washtub
