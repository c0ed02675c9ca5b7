#include "record/observer.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "cloth/thread.hpp"
#include "measure/trajectory.hpp"

namespace washtub {

namespace {

/// (x, y) of the axis of the first solid that turns; the origin where none does.
Vec<2> turning_axis(const std::vector<Solid>& solids) {
  for (const auto& s : solids)
    if (s.drive.moving()) return s.centre.head<2>();
  return Vec<2>::Zero();
}

/// Whether a thread is closed without a shift, and so encloses an area.
bool is_ring(const Sheet<2>& sheet) { return sheet.closed[1] && sheet.period[1].isZero(); }

Interval window(const Case& whole) { return {whole.output.window_begin, whole.output.window_end}; }

}  // namespace

template <int D>
Observer<D>::Observer(Simulation<D>& simulation)
    : simulation_(simulation),
      axis_(turning_axis(simulation.mapping().solids())),
      statistics_(no_statistics()),
      sampled_(simulation.time()),
      steady_(simulation.cloth(), simulation.definition().output.stress_time),
      self_watch_(simulation) {
  if (simulation.definition().exact) exact_.emplace(*simulation.definition().exact);
  const auto n = simulation.cloth().position.size();
  for (auto* v : {&membrane_, &bending_, &total_}) v->resize(n);
  for (const auto& g : simulation.cloth().groups) {
    const std::size_t edges = g.pieces > 0 ? steady_.of_piece(g.first_piece).edges() : 0;
    cycles_.emplace_back(edges * static_cast<std::size_t>(g.pieces));
  }
}

template <int D>
ClothStatistics Observer<D>::no_statistics() const {
  const Case& c = simulation_.definition();
  return {static_cast<std::size_t>(simulation_.cloth().pieces()), window(c), c.scale.period, axis_};
}

template <int D>
StepSample Observer<D>::observe_step() const {
  const auto& last = simulation_.last();
  return {static_cast<double>(last.number),
          last.dt,
          last.courant,
          last.divergence,
          static_cast<double>(last.pressure.cycles),
          last.speed,
          last.kinetic,
          last.cloth.largest_strain,
          last.cloth.slip,
          static_cast<double>(last.cloth.iterations)};
}

template <int D>
QualitySample Observer<D>::observe_quality(const std::vector<SolidSample>& solids) {
  double power = 0;
  for (const SolidSample& solid : solids) power += solid.power;
  return self_watch_.observe(power);
}

template <int D>
SolidSample Observer<D>::observe_solid(std::size_t s, double time) {
  const Drive& drive = simulation_.mapping().solids()[s].drive;
  const auto loads = simulation_.loads(s);
  SolidSample solid;
  solid.angle = drive.angle(time);
  solid.friction = loads.friction.torque;
  solid.pressure = loads.pressure.torque;
  solid.convection = loads.convection.torque;
  solid.torque = loads.total().torque;
  solid.rms_torque = std::abs(solid.torque);
  solid.force.head<D>() = loads.total().force;
  if (!drive.moving()) return solid;
  const Impulse since = simulation_.take_impulse(s);
  if (!(since.time > 0)) return solid;
  solid.speed = since.angle / since.time;
  solid.power = -since.work / since.time;
  solid.torque = since.moment / since.time;
  solid.rms_torque = std::sqrt(since.squared / since.time);
  return solid;
}

template <int D>
PieceSample Observer<D>::observe_piece(const ClothGroup<D>& g, int p) {
  const auto X = simulation_.cloth().piece(g, p);
  const auto first = static_cast<std::size_t>(g.node(p, 0));
  node_stress_.resize(X.size());
  PieceSample sample;
  find_strains(g.sheet, X, strains_);
  find_stress(g.sheet, X, strains_, node_stress_);
  sample.raw_stress = area_mean(node_stress_, g.sheet.area, &NodeStress::total);
  find_stress(g.sheet, X, steady_.of_piece(g.first_piece + p), node_stress_);
  sample.tension = area_mean(node_stress_, g.sheet.area, &NodeStress::tension);
  sample.compression = area_mean(node_stress_, g.sheet.area, &NodeStress::compression);
  for (std::size_t i = 0; i < node_stress_.size(); ++i) {
    membrane_[first + i] = node_stress_[i].membrane;
    bending_[first + i] = node_stress_[i].bending;
    total_[first + i] = node_stress_[i].total;
  }
  const auto part = [&](const std::vector<double>& v) {
    return std::span(v).subspan(first, node_stress_.size());
  };
  sample.centre = radius_height<D>(centre_of_mass<D>(X, g.sheet.area), axis_);
  sample.stress = area_mean({part(membrane_), part(bending_), part(total_)}, g.sheet.area);
  return sample;
}

namespace {

/// Of what was counted in a span of time, per edge [1/s].
double rate(double counted, std::size_t edges, const Interval& over) {
  const double all = static_cast<double>(edges) * over.length();
  return all > 0 ? counted / all : 0;
}

PieceSample mean_of(std::span<const PieceSample> all) {
  PieceSample mean{Vec<2>::Zero(), {}};
  const double pieces = static_cast<double>(all.size());
  for (const PieceSample& p : all) {
    mean.centre += p.centre / pieces;
    mean.stress.membrane += p.stress.membrane / pieces;
    mean.stress.bending += p.stress.bending / pieces;
    mean.stress.total += p.stress.total / pieces;
    mean.raw_stress += p.raw_stress / pieces;
    mean.tension += p.tension / pieces;
    mean.compression += p.compression / pieces;
  }
  return mean;
}

}  // namespace

template <int D>
void Observer<D>::observe_cloth(Sample& sample, const Interval& since) {
  double area = 0;
  for (const auto& g : simulation_.cloth().groups) {
    const double piece_area = std::accumulate(g.sheet.area.begin(), g.sheet.area.end(), 0.0);
    for (int p = 0; p < g.pieces; ++p) {
      sample.pieces.push_back(observe_piece(g, p));
      sample.centre += piece_area * sample.pieces.back().centre;
      area += piece_area;
    }
    sample.groups.push_back(
        mean_of(std::span(sample.pieces).last(static_cast<std::size_t>(g.pieces))));
  }
  if (area > 0) sample.centre /= area;
  const PieceSample mean = mean_of(sample.pieces);
  sample.stress = mean.stress;
  sample.raw_stress = mean.raw_stress;
  sample.tension = mean.tension;
  sample.compression = mean.compression;
  observe_quantiles(sample);
  observe_cycles(sample, since);
  collect(sample.pieces, since);
}

/// Hands the strains of all edges to the counts of cycles.
template <int D>
void Observer<D>::count_cycles() {
  const auto& groups = simulation_.cloth().groups;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    std::size_t signal = 0;
    for (int p = 0; p < groups[g].pieces; ++p)
      for (const auto& axis : steady_.of_piece(groups[g].first_piece + p).along)
        for (const double strain : axis) cycles_[g].add(signal++, strain);
  }
}

/// Quantiles of the stress over each group's area, and over that of all.
template <int D>
void Observer<D>::observe_quantiles(Sample& sample) {
  const auto& groups = simulation_.cloth().groups;
  std::vector<Weighted> all, own;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    own.clear();
    const auto& area = groups[g].sheet.area;
    const auto first = static_cast<std::size_t>(groups[g].first_node);
    for (std::size_t i = 0; i < static_cast<std::size_t>(groups[g].nodes()); ++i)
      own.push_back({total_[first + i], area[i % area.size()]});
    all.insert(all.end(), own.begin(), own.end());
    if (!own.empty()) sample.groups[g].quantiles = quantiles(own, stress_parts);
  }
  sample.quantiles = groups.size() == 1 ? sample.groups[0].quantiles : quantiles(all, stress_parts);
}

/// Strain cycles of each group's edges, and of all, since the sample before.
template <int D>
void Observer<D>::observe_cycles(Sample& sample, const Interval& since) {
  std::size_t edges = 0;
  for (std::size_t g = 0; g < cycles_.size(); ++g) {
    const auto counted = cycles_[g].take();
    edges += cycles_[g].signals();
    for (std::size_t k = 0; k < counted.size(); ++k) {
      sample.strain_cycles[k] += counted[k];
      sample.groups[g].strain_cycles[k] = rate(counted[k], cycles_[g].signals(), since);
    }
  }
  for (double& counted : sample.strain_cycles) counted = rate(counted, edges, since);
}

template <int D>
void Observer<D>::collect(const std::vector<PieceSample>& pieces, const Interval& since) {
  const auto& cloth = simulation_.cloth();
  std::vector<StressParts> stress;
  for (const PieceSample& p : pieces) stress.push_back(p.stress);
  statistics_.add(since, [&](ClothStatistics::Part& part) {
    part.stress.add(since, stress);
    for (const auto& g : cloth.groups)
      for (int p = 0; p < g.pieces; ++p)
        part.scatter.template add<D>(since, static_cast<std::size_t>(g.first_piece + p),
                                     cloth.piece(g, p), g.sheet.area);
  });
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
Sample Observer<D>::observe() {
  Sample sample;
  sample.time = simulation_.time();
  sample.step = observe_step();
  for (std::size_t s = 0; s < simulation_.definition().solids.size(); ++s)
    sample.solids.push_back(observe_solid(s, sample.time));
  sample.quality = observe_quality(sample.solids);
  if (simulation_.cloth().pieces() > 0) observe_cloth(sample, {sampled_, sample.time});
  observe_probes(sample);
  observe_rings(sample);
  if (exact_) sample.error = exact_->compare(simulation_);
  sampled_ = sample.time;
  return sample;
}

/// Below this water is as good as still [m/s]: a hundredth of the drive's speed and of the largest
/// one so far; a Reynolds number of 1e-6.
template <int D>
double Observer<D>::least_speed() const {
  const Case& c = simulation_.definition();
  const double length = c.scale.length > 0 ? c.scale.length : c.domain.size.x();
  const double creep = 1e-6 * c.fluid.viscosity / (c.fluid.density * length);
  return std::max({0.01 * c.scale.speed * length, 0.01 * extremes_.speed, creep});
}

template <int D>
void Observer<D>::watch(const typename Simulation<D>::Step& step) {
  steady_.add(simulation_.cloth(), step.dt);
  count_cycles();
  auto& e = extremes_;
  e.divergence = std::max(e.divergence, step.divergence);
  e.courant = std::max(e.courant, step.courant);
  e.speed = std::max(e.speed, step.speed);
  if (step.cloth.looked) {
    const double share = step.cloth.slip / std::max(step.speed, least_speed());
    e.slip = std::max(e.slip, step.cloth.slip);
    e.slip_share = std::max(e.slip_share, share);
    e.sum_of_slip_shares += share;
    ++e.slip_looks;
  }
  e.depth = std::max(e.depth, step.cloth.barrier.depth);
  e.penetration = std::max(e.penetration, step.cloth.barrier.penetration);
  e.strain = std::max(e.strain, step.cloth.largest_strain);
  e.touched += step.cloth.barrier.touched;
  e.held += step.cloth.contact.held;
  e.cut += step.cloth.contact.cut;
  e.cycles += step.pressure.cycles;
  e.newton += step.cloth.iterations;
  e.unconverged += !step.pressure.converged;
  e.largest_step = std::max(e.largest_step, step.dt);
  e.smallest_step = std::min(e.smallest_step, step.dt);
}

template <int D>
void Observer<D>::state(Archive& archive) {
  archive.value("cloth", statistics_);
  archive.value("extremes", extremes_);
  archive.value("sampled", sampled_);
  archive.value("steady", steady_);
  archive.value("cycles", cycles_);
  archive.value("self-watch", self_watch_);
  // What was collected was over the window then, which may have been another one.
  if (archive.reading() && window(simulation_.definition()).begin >= sampled_)
    statistics_ = no_statistics();
}

template class Observer<2>;
template class Observer<3>;

}  // namespace washtub
