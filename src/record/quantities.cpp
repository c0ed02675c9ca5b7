#include "record/quantities.hpp"

#include <cmath>

#include "measure/blocks.hpp"
#include "record/names.hpp"

namespace washtub {

namespace quantities_of {

const std::vector<DeclaredQuantity<ClothHistory>> cloth = {
    {{names::stress, pascal, "mean of the stress over time, area and pieces"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::stress); }},
    {{names::membrane_stress, pascal, "its part of stretching and shear"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::membrane_stress); }},
    {{names::bending_stress, pascal, "its part of bending and twisting"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::bending_stress); }},
    {{names::tension, pascal, "of its membrane part, along edges that are stretched"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::tension); }},
    {{names::compression, pascal, "likewise, along edges that are compressed"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::compression); }},
    {{names::raw_stress, pascal, "of the stress with the strains of each instant"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::raw_stress); }},
    {{names::stress_50, pascal, "that 50 % of the cloth's area stay below, mean over time"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::stress_50); }},
    {{names::stress_90, pascal, "that 90 % of the cloth's area stay below, mean over time"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::stress_90); }},
    {{names::stress_99, pascal, "that 99 % of the cloth's area stay below, mean over time"},
     Scale::stress,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::stress_99); }},
    {{names::strain_cycles_small, per_second,
      "rainflow cycles of an edge's strain by that or more, per edge and time"},
     Scale::none,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::strain_cycles_small); }},
    {{names::strain_cycles_middle, per_second,
      "rainflow cycles of an edge's strain by that or more, per edge and time"},
     Scale::none,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::strain_cycles_middle); }},
    {{names::strain_cycles_large, per_second,
      "rainflow cycles of an edge's strain by that or more, per edge and time"},
     Scale::none,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::strain_cycles_large); }},
    {{names::radius, metre, "mean distance of the pieces' centres from the axis"},
     Scale::length,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::radius); }},
    {{names::height, metre, "mean height of the pieces' centres", When::space},
     Scale::height,
     true,
     [](const ClothHistory& h) { return h.columns.mean(names::height); }},
};

const std::vector<DeclaredQuantity<SolidHistory>> solid = {
    {{names::rms_torque, newton_metre,
      "root of the mean square of the torque on the solid: over "
      "all steps of one that turns, over the rows of one at rest"},
     Scale::torque,
     true,
     [](const SolidHistory& h) {
       const auto over_steps = h.columns.rms(names::rms_torque);
       return over_steps ? over_steps : h.columns.rms(names::torque);
     }},
    {{"rms skin friction torque", newton_metre, "of the part of skin friction, over the rows"},
     Scale::torque,
     false,
     [](const SolidHistory& h) { return h.columns.rms(names::friction); }},
    {{"rms pressure torque", newton_metre, "of the part of the pressure, over the rows"},
     Scale::torque,
     false,
     [](const SolidHistory& h) { return h.columns.rms(names::pressure); }},
    {{"rms convective torque", newton_metre,
      "of the momentum carried into the steps of the cells, "
      "over the rows"},
     Scale::torque,
     false,
     [](const SolidHistory& h) { return h.columns.rms(names::convection); }},
    {{"rms friction and pressure torque", newton_metre, "of the sum of both, over the rows"},
     Scale::torque,
     false,
     [](const SolidHistory& h) { return h.columns.rms_of_sum(names::friction, names::pressure); }},
    {{names::mean_power, watt, "given to the water", When::moving},
     Scale::none,
     true,
     [](const SolidHistory& h) { return h.columns.mean(names::power); }},
    {{names::energy, joule, "given to the water in a whole cycle of the solid's drive",
      When::moving},
     Scale::none,
     true,
     [](const SolidHistory& h) {
       return h.columns.per_cycle(names::power, h.solid.drive.period());
     }},
};

}  // namespace quantities_of

namespace {

struct NamedScale {
  const char* name;
  double size;  ///< 0: the case has none
};

NamedScale named(Scale scale, const Case& whole) {
  const auto of_case = scales(whole);
  switch (scale) {
    case Scale::stress:
      return {"sigma_o", of_case ? of_case->stress : 0};
    case Scale::torque:
      return {"tau_o", of_case ? of_case->torque : 0};
    case Scale::length:
      return {"r_o", whole.scale.length};
    case Scale::height:
      return {"H", whole.scale.height};
    case Scale::none:
      break;
  }
  return {"", 0};
}

template <class Source>
std::vector<RunQuantity> find(const std::vector<DeclaredQuantity<Source>>& declared,
                              const Source& source, const Case& whole, bool moving) {
  std::vector<RunQuantity> found;
  for (const auto& quantity : declared) {
    const Declared& about = quantity.about;
    if (!about.applies(whole.dimension, moving)) continue;
    const auto statistic = quantity.take(source);
    if (!statistic) continue;
    const NamedScale scale = named(quantity.scale, whole);
    const bool scaled = scale.size > 0;
    found.push_back({about.name, about.unit.in(whole.dimension), statistic->value,
                     statistic->batches, scaled ? scale.name : "", scaled ? scale.size : 1,
                     about.meaning, quantity.on_page});
  }
  return found;
}

}  // namespace

WindowedHistory::WindowedHistory(const Case& whole, const CsvTable& history,
                                 const std::string& owner)
    : history_(history),
      owner_(owner.empty() ? "" : owner + ' '),
      times_(history.columns()[0].values),
      window_{whole.output.window_begin, whole.output.window_end},
      averaging_(
          washtub::averaging(window_, times_.empty() ? 0 : times_.back(), whole.scale.period)) {}

const std::vector<double>* WindowedHistory::find(const std::string& column) const {
  const auto* found = history_.find(owner_ + column);
  return found ? &found->values : nullptr;
}

std::optional<Statistic> WindowedHistory::take(const std::vector<double>& values,
                                               const Averaging& averaging, Moment moment) const {
  Statistic found = statistic(times_, values, averaging, moment);
  return std::isfinite(found.value) ? std::optional(std::move(found)) : std::nullopt;
}

std::optional<Statistic> WindowedHistory::mean(const std::string& column) const {
  const auto* values = find(column);
  return values ? take(*values, averaging_, Moment::mean) : std::nullopt;
}

std::optional<Statistic> WindowedHistory::rms(const std::string& column) const {
  const auto* values = find(column);
  return values ? take(*values, averaging_, Moment::rms) : std::nullopt;
}

std::optional<Statistic> WindowedHistory::rms_of_sum(const std::string& one,
                                                     const std::string& other) const {
  const auto *a = find(one), *b = find(other);
  if (!a || !b) return {};
  std::vector<double> sum = *a;
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += (*b)[i];
  return take(sum, averaging_, Moment::rms);
}

std::optional<Statistic> WindowedHistory::per_cycle(const std::string& column,
                                                    double period) const {
  const auto* values = find(column);
  if (!values || times_.empty()) return {};
  const Averaging cycles = washtub::averaging(window_, times_.back(), period);
  if (cycles.cycles == 0) return {};
  auto found = take(*values, cycles, Moment::mean);
  if (!found) return {};
  found->value *= period;
  for (double& batch : found->batches) batch *= period;
  return found;
}

std::vector<double> RunQuantity::independent() const {
  return seeds.empty() ? independent_blocks(batches) : batches;
}

std::optional<double> RunQuantity::half_width() const {
  const double width = mean_of_batches(independent()).half_width;
  return std::isfinite(width) ? std::optional(width) : std::nullopt;
}

std::vector<RunQuantity> cloth_quantities(const Case& whole, const CsvTable& history) {
  return find(quantities_of::cloth, {WindowedHistory(whole, history)}, whole, false);
}

std::vector<RunQuantity> group_quantities(const Case& whole, const ClothCase& group,
                                          const CsvTable& history) {
  return find(quantities_of::cloth, {WindowedHistory(whole, history, group.name)}, whole, false);
}

std::vector<RunQuantity> solid_quantities(const Case& whole, const SolidCase& solid,
                                          const CsvTable& history) {
  const bool moving = solid.drive.moving();
  return find(quantities_of::solid, {WindowedHistory(whole, history, solid.name), solid}, whole,
              moving);
}

}  // namespace washtub
