#include "washer/simulation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "base/error.hpp"
#include "case/vector_field.hpp"
#include "cloth/weight.hpp"
#include "washer/build.hpp"
#include "washer/pull.hpp"
#include "washer/resolution.hpp"
#include "washer/watch.hpp"

namespace washtub {
namespace {

constexpr double growth = 1.1;  // of the time step from one step to the next
constexpr int slip_look = 8;    // steps from one look at the slip to the next

}  // namespace

const char* name(StepLimit limit) {
  constexpr const char* names[] = {"step", "cfl", "growth", "sample", "slip", "caution"};
  return names[static_cast<int>(limit)];
}

template <int D>
Simulation<D>::Simulation(const Case& whole, const Parallel& parallel, Archive* developed,
                          const std::vector<Vec<D>>& places)
    : case_(whole),
      grid_(build_mesh<D>(whole), parallel, granularity(build_mesh<D>(whole))),
      mapping_(grid_, build_solids(whole), build_heaviside(whole)),
      flow_(grid_, whole.fluid.density, whole.fluid.viscosity, build_sides<D>(whole),
            {mapping_.open(), mapping_.held()}),
      surface_water_(grid_, mapping_, whole.fluid.density),
      cloth_(build_cloth<D>(whole)),
      impulses_(whole.solids.size()),
      moments_(whole.solids.size()),
      surface_momenta_(mapping_.solids().size()) {
  if (!places.empty() && places.size() != cloth_.position.size())
    throw std::logic_error("Simulation: needs a place for each node");
  if (!places.empty()) cloth_.position = places;
  start_water();
  if (developed) take_developed(*developed);
  courant_rate_ = start_rate();
  driving_speed_ = washtub::driving_speed<D>(grid_, mapping_, build_sides<D>(whole), last_.speed);
  ContactSettings contact = build_contact(whole);
  if (!places.empty()) contact.rise = 0;  // what has settled has parted
  if (cloth_.pieces() > 0)
    coupling_.emplace(flow_, cloth_, mapping_, whole.coupling.kernel, build_sides<D>(whole),
                      whole.coupling.scheme, whole.coupling.marker_spacing, &clock_, contact);
  if (coupling_) add_forces();
  find_surface_momenta();
}

/// What acts on the cloth besides the water and what it touches.
template <int D>
void Simulation<D>::add_forces() {
  coupling_->add(std::make_unique<Weight<D>>(cloth_, case_.fluid.gravity.template head<D>()));
  if (Pull<D>::any(case_)) coupling_->add(std::make_unique<Pull<D>>(cloth_, case_));
}

/// The water's velocity at t = 0, and that of the solids on the faces that they close.
template <int D>
void Simulation<D>::start_water() {
  if (case_.fluid.velocity == FluidCase().velocity) return;
  const VectorField<D> field(case_.fluid.velocity, "the velocity");
  flow_.set_velocity([&](const Vec<D>& x) { return field(x); });
  mapping_.impose(flow_.velocity());
  flow_.refresh_ghosts();
  measure_start();
}

/// Water and cloth of another simulation; faces that this one's solids close move with them.
template <int D>
void Simulation<D>::take_developed(Archive& developed) {
  struct WaterAndCloth {
    Flow<D>& flow;
    Cloth<D>& cloth;
    void state(Archive& archive) {
      archive.value("flow", flow);
      archive.value("cloth", cloth);
    }
  } both{flow_, cloth_};
  both.state(developed);
  flow_.restart();
  mapping_.still(flow_.velocity());
  mapping_.impose(flow_.velocity());
  flow_.refresh_ghosts();
  measure_start();
}

template <int D>
void Simulation<D>::state(Archive& archive) {
  archive.value("mapping", mapping_);
  archive.value("flow", flow_);
  archive.value("cloth", cloth_);
  if (coupling_) archive.value("coupling", *coupling_);
  archive.value("step", last_.number);
  archive.value("time", last_.time);
  archive.value("time step", last_.dt);
  archive.value("speed", last_.speed);
  archive.value("kinetic energy", last_.kinetic);
  archive.value("courant rate", courant_rate_);
  archive.value("driving speed", driving_speed_);
  archive.value("slip cut", slip_cut_);
  archive.value("caution", caution_);
  archive.value("wanted step", wanted_step_);
  archive.same_length("impulses", impulses_);
  if (archive.reading()) find_surface_momenta();
}

/// Moments of momentum of the water at the surfaces of the solids that move, as it is now.
template <int D>
void Simulation<D>::find_surface_momenta() {
  for (std::size_t s = 0; s < surface_momenta_.size(); ++s)
    if (mapping_.solids()[s].drive.moving())
      surface_momenta_[s] = surface_water_.momentum(s, flow_.velocity()).torque;
}

/// Speed and kinetic energy at t = 0.
template <int D>
void Simulation<D>::measure_start() {
  const auto& block = grid_.block();
  double squares = 0;
  for (int d = 0; d < D; ++d)
    for (int k = 0; k < block.planes(); ++k)
      for (int j = 0; j < block.rows(); ++j)
        for (long p = block.row(j, k), end = p + block.width(); p < end; ++p) {
          const double u = flow_.velocity()[d][p];
          last_.speed = std::max(last_.speed, std::abs(u));
          squares += mapping_.open()[d][p] * u * u;
        }
  last_.speed = grid_.parallel().max(last_.speed);
  last_.kinetic =
      0.5 * flow_.density() * grid_.mesh().cell_volume() * grid_.parallel().sum(squares);
}

/// Longest first step: what pulls at cloth that is stretched, bent or heavy must not carry it, with
/// two cells of water, further than the CFL number allows.
template <int D>
double Simulation<D>::start_step() const {
  const double h = grid_.mesh().h.minCoeff(), water = 2 * h * case_.fluid.density;
  double fastest = 0;
  std::vector<Vec<D>> pull(cloth_.position.size(), Vec<D>::Zero());
  if (Pull<D>::any(case_)) Pull<D>(cloth_, case_).add({cloth_.position, cloth_.velocity, 0}, pull);
  for (const auto& g : cloth_.groups) {
    const double excess = g.sheet.material.excess_mass;
    const Vec<D> weight = excess * case_.fluid.gravity.template head<D>();
    std::vector<Vec<D>> F(static_cast<std::size_t>(g.sheet.nodes()));
    for (int p = 0; p < g.pieces; ++p) {
      g.sheet.force(cloth_.piece(g, p), F);
      for (std::size_t i = 0; i < F.size(); ++i) {
        const Vec<D> given = F[i] + pull[static_cast<std::size_t>(g.node(p, static_cast<int>(i)))];
        fastest = std::max(fastest, (given / g.sheet.area[i] + weight).norm() / (water + excess));
      }
    }
  }
  return fastest > 0 ? std::sqrt(2 * case_.time.cfl * h / fastest) : case_.time.end;
}

/// Bound of sum |u| / h from the water, sides and solids that move when the run starts.
template <int D>
double Simulation<D>::start_rate() const {
  double speed = last_.speed;
  for (const auto& side : case_.domain.sides) speed = std::max(speed, side.velocity.norm());
  for (const auto& solid : mapping_.solids())
    speed = std::max(speed, std::abs(solid.drive.speed(0)) * grid_.mesh().size().norm());
  return speed * grid_.mesh().h.cwiseInverse().sum();
}

/// Length of the next step; also notes what limits it.
template <int D>
double Simulation<D>::choose_step(double latest) {
  const auto& time = case_.time;
  last_.limit = StepLimit::given;
  if (time.fixed) return time.step;
  double dt = time.step > 0 ? time.step : time.end;
  const auto take = [&](double bound, StepLimit limit) {
    if (bound < dt) dt = bound, last_.limit = limit;
  };
  if (courant_rate_ > 0) take(time.cfl / courant_rate_, StepLimit::courant);
  if (slip_cut_.factor() < 1) take(slip_cut_.factor() * dt, StepLimit::slip);
  if (caution_ < 1) take(caution_ * dt, StepLimit::caution);
  take(wanted_step_ > 0 ? growth * wanted_step_ : start_step(), StepLimit::growth);
  wanted_step_ = dt;
  const double left = latest - last_.time;
  const double even = left / std::max(1.0, std::ceil(left / dt - 1e-3));  // up to the sample
  if (even < 0.999 * dt) last_.limit = StepLimit::sample;
  return even;
}

/// Of the pressure solve in this step.
template <int D>
int Simulation<D>::most_cycles() const {
  return static_cast<int>(std::lround(case_.solver.max_cycles / (caution_ * caution_)));
}

template <int D>
void Simulation<D>::move_solids(double dt) {
  const auto& solids = mapping_.solids();
  std::fill(moments_.begin(), moments_.end(), 0);
  for (std::size_t s = 0; s < solids.size(); ++s)
    if (solids[s].drive.moving()) moments_[solids[s].body] += surface_momenta_[s];
  const auto change = mapping_.update(last_.time + dt);
  last_.flips = change.flipped;
  const auto [k0, k1] = mapping_.moving_planes();
  if (change.any) flow_.openings_changed(k0, k1, change.flipped);
  for (std::size_t s = 0; s < solids.size(); ++s)
    if (solids[s].drive.moving())
      moments_[solids[s].body] += surface_water_.joined(s, flow_.velocity()).torque;
  mapping_.impose(flow_.velocity());
}

/// The paper's equations in the order in which they are solved.
template <int D>
void Simulation<D>::move_cloth_and_water(double dt, bool measure_slip) {
  clock_.enter(Phase::prediction);
  flow_.predict(dt);  // Eq. (1) without pressure and cloth
  if (coupling_) clock_.enter(Phase::exchange);
  if (coupling_) coupling_->push();  // cloth solve; f = S F, Eq. (3)
  const auto project = [&] {
    const InPhase projecting(&clock_, Phase::projection);
    return flow_.project(case_.solver.divergence, most_cycles());
  };
  auto flow = project();                                       // Eq. (2)
  while (coupling_ && coupling_->again()) flow = project();    // with the force of a better X^n+1
  if (coupling_) last_.cloth = coupling_->move(measure_slip);  // dX/dt = U, Eqs. (5), (6)

  last_.pressure = flow.pressure;
  last_.divergence = flow.divergence;
  last_.speed = flow.speed;
  last_.kinetic = flow.kinetic;
  last_.courant = flow.courant * dt;
  courant_rate_ = flow.courant;
}

template <int D>
const typename Simulation<D>::Step& Simulation<D>::step(double latest) {
  const double dt = choose_step(latest);
  clock_.enter(Phase::solids);
  move_solids(dt);  // u = u_o where psi > 0, Eq. (9)
  const bool last_before_row = latest - last_.time <= (1 + 1e-6) * dt;
  move_cloth_and_water(dt, last_before_row || last_.number % slip_look == 0);
  last_.time += dt;
  last_.dt = dt;
  ++last_.number;
  clock_.enter(Phase::loads);
  record_impulses(dt);
  clock_.enter(Phase::rest);
  if (last_.cloth.looked) slip_cut_.look(last_.speed > 0 ? last_.cloth.slip / last_.speed : 0);
  caution_ = std::min(1.0, 1.02 * caution_);
  watch();
  return last_;
}

template <int D>
WaterState<D> Simulation<D>::water() const {
  WaterState<D> w{{}, flow_.pressure().data(), {}, flow_.density(), flow_.viscosity()};
  for (int d = 0; d < D; ++d) {
    w.velocity[d] = flow_.velocity()[d].data();
    w.force[d] = flow_.force()[d].data();
  }
  return w;
}

template <int D>
void Simulation<D>::record_impulses(double dt) {
  const auto& solids = mapping_.solids();
  find_surface_momenta();
  for (std::size_t s = 0; s < solids.size(); ++s) {
    if (!solids[s].drive.moving()) continue;
    double& moment = moments_[solids[s].body];
    moment += dt * surface_torque<D>(grid_, mapping_, s, water());
    moment -= surface_momenta_[s];
    if (coupling_ && grid_.parallel().root()) moment += dt * coupling_->contact_moment(s);
  }
  grid_.parallel().sum(std::span<double>(moments_));
  for (std::size_t s = 0; s < impulses_.size(); ++s) {
    const Drive& drive = solids[s].drive;
    const double swept = drive.angle(last_.time) - drive.angle(last_.time - dt);
    impulses_[s].moment += moments_[s];
    impulses_[s].work += moments_[s] / dt * swept;
    impulses_[s].squared += moments_[s] / dt * moments_[s];
    impulses_[s].angle += swept;
    impulses_[s].time += dt;
  }
}

template <int D>
Impulse Simulation<D>::take_impulse(std::size_t solid) {
  return std::exchange(impulses_[solid], {});
}

template <int D>
SurfaceLoads<D> Simulation<D>::loads(std::size_t solid) const {
  SurfaceLoads<D> l;
  for (std::size_t s = 0; s < mapping_.solids().size(); ++s)
    if (mapping_.solids()[s].body == solid) l += surface_loads<D>(grid_, mapping_, s, water());
  for (auto* part : {&l.friction, &l.pressure, &l.convection, &l.cloth}) {
    grid_.parallel().sum(std::span<double>(part->force.data(), D));
    part->torque = grid_.parallel().sum(part->torque);
  }
  return l;
}

template <int D>
bool Simulation<D>::finite() const {
  return std::isfinite(last_.kinetic) && std::all_of(cloth_.position.begin(), cloth_.position.end(),
                                                     [](const Vec<D>& x) { return x.allFinite(); });
}

template <int D>
void Simulation<D>::watch() const {
  const StepHealth step{.number = last_.number,
                        .time = last_.time,
                        .dt = last_.dt,
                        .courant = last_.courant,
                        .divergence = last_.divergence,
                        .converged = last_.pressure.converged,
                        .cycles = last_.pressure.cycles,
                        .speed = last_.speed,
                        .kinetic = last_.kinetic,
                        .strain = last_.cloth.largest_strain,
                        .slip = last_.cloth.slip,
                        .driving_speed = driving_speed_};
  const auto trouble = find_trouble(step, flow_, cloth_, case_);
  if (!trouble) return;
  if (trouble->kind == TroubleKind::pressure) throw PressureError(trouble->text);
  throw RunError(trouble->text);
}

template class Simulation<2>;
template class Simulation<3>;

}  // namespace washtub
