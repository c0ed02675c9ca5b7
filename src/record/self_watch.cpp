#include "record/self_watch.hpp"

#include <algorithm>

#include "cloth/energy.hpp"
#include "contact/neighbours.hpp"
#include "flow/dissipation.hpp"
#include "washer/build.hpp"

namespace washtub {
namespace {

constexpr double neighbourhood = 1.5;  // lateral cells, within which cloth counts as near

}  // namespace

template <int D>
SelfWatch<D>::SelfWatch(const Simulation<D>& simulation)
    : simulation_(simulation),
      sides_(build_sides<D>(simulation.definition())),
      closed_(is_closed(simulation.definition())),
      near_later_{Persistence(simulation.definition().scale.period / 4),
                  Persistence(simulation.definition().scale.period)} {}

/// `work` since the start.
template <int D>
EnergyState SelfWatch<D>::energy_now(double work) const {
  return {.time = simulation_.time(),
          .stored = simulation_.last().kinetic + energy(simulation_.cloth()),
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
  const double forces = simulation_.work_on_cloth();
  const double work = dt * (power + 0.5 * (sides + power_of_sides_)) + forces - work_on_cloth_;
  const EnergyState now = energy_now(energy_.work + work);
  EnergyBalance since;
  since.add(energy_, now);
  row_.dissipation = now.dissipation;
  row_.residual = !first && dt > 0 ? since.rest() / dt : 0;
  if (!first) quality_.balance.add(energy_, now);
  energy_ = now;
  power_of_sides_ = sides;
  work_on_cloth_ = forces;
  return row_;
}

template <int D>
void SelfWatch<D>::look_at_cloth() {
  if (simulation_.cloth().pieces() == 0) return;
  count_crossings();
  const Case& whole = simulation_.definition();
  const double reach = neighbourhood * whole.domain.size[0] / whole.domain.cells[0];
  const Neighbours found = find_neighbours(simulation_.cloth(), simulation_.grid().mesh(), reach);
  quality_.gap = std::min(quality_.gap, found.gap);
  quality_.own_gap = std::min(quality_.own_gap, found.own_gap);
  for (std::size_t i = 0; i < near_later_.size(); ++i) {
    near_later_[i].add(simulation_.time(), found.nodes);
    quality_.still_near[i] = near_later_[i].share();
  }
}

template <int D>
void SelfWatch<D>::count_crossings() {
  quality_.crossings = find_crossings(simulation_.cloth(), simulation_.grid().mesh());
  quality_.crossings.pieces.clear();  // which they are is not kept
  quality_.most_crossings = std::max(quality_.most_crossings, quality_.crossings.others);
  quality_.most_own_crossings = std::max(quality_.most_own_crossings, quality_.crossings.own);
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
  archive.value("work on cloth", work_on_cloth_);
  archive.value("near a quarter later", near_later_[0]);
  archive.value("near a period later", near_later_[1]);
  archive.value("alarmed", alarmed_);
}

template class SelfWatch<2>;
template class SelfWatch<3>;

}  // namespace washtub
