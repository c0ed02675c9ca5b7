#include "record/self_watch.hpp"

#include <algorithm>

#include "cloth/energy.hpp"
#include "flow/dissipation.hpp"
#include "washer/build.hpp"

namespace washtub {
template <int D>
SelfWatch<D>::SelfWatch(const Simulation<D>& simulation)
    : simulation_(simulation),
      sides_(build_sides<D>(simulation.definition())),
      closed_(is_closed(simulation.definition())) {}

/// `work` since the start.
template <int D>
EnergyState SelfWatch<D>::energy_now(double work) const {
  const Vec<D> gravity = simulation_.definition().fluid.gravity.template head<D>();
  return {.time = simulation_.time(),
          .stored = simulation_.last().kinetic + energy<D>(simulation_.cloth(), gravity),
          .work = work,
          .dissipation = dissipation(simulation_.flow())};
}

template <int D>
const QualitySample& SelfWatch<D>::observe(double power) {
  row_.resolution =
      find_resolution(simulation_.flow(), simulation_.driving_speed(), simulation_.last().speed);
  quality_.worst.take_worst(row_.resolution);
  if (!closed_) return row_;
  const double sides = power_of_sides<D>(simulation_.flow(), sides_);
  const bool first = simulation_.last().number == 0;
  const double dt = simulation_.time() - energy_.time;
  const EnergyState now = energy_now(energy_.work + dt * (power + 0.5 * (sides + power_of_sides_)));
  EnergyBalance since;
  since.add(energy_, now);
  row_.dissipation = now.dissipation;
  row_.residual = !first && dt > 0 ? since.rest() / dt : 0;
  if (!first) quality_.balance.add(energy_, now);
  energy_ = now;
  power_of_sides_ = sides;
  return row_;
}

template <int D>
const Crossings& SelfWatch<D>::count_crossings() {
  quality_.crossings = find_crossings(simulation_.cloth(), simulation_.grid().mesh());
  quality_.most_crossings = std::max(quality_.most_crossings, quality_.crossings.others);
  quality_.most_own_crossings = std::max(quality_.most_own_crossings, quality_.crossings.own);
  return quality_.crossings;
}

template <int D>
std::optional<std::string> SelfWatch<D>::first_alarm() {
  if (alarmed_) return {};
  auto text = unresolved(quality_.worst, simulation_.definition());
  alarmed_ = text.has_value();
  return text;
}

template <int D>
void SelfWatch<D>::state(Archive& archive) {
  archive.value("quality", quality_);
  archive.value("energy", energy_);
  archive.value("power of sides", power_of_sides_);
  archive.value("alarmed", alarmed_);
}

template class SelfWatch<2>;
template class SelfWatch<3>;

}  // namespace washtub
