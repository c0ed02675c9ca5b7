#include <cmath>
#include <numeric>

#include "record/build_facts.hpp"
#include "record/columns.hpp"
#include "record/names.hpp"
#include "record/summarise.hpp"

namespace washtub {

using Json = nlohmann::ordered_json;

namespace {

double cells(const Case& whole) {
  double cells = 1;
  for (int d = 0; d < whole.dimension; ++d)
    cells *= whole.domain.cells[static_cast<std::size_t>(d)];
  return cells;
}

/// A sum over all steps, over their number.
double per_step(double sum, const RunSource& s) { return sum / static_cast<double>(s.end.steps); }

/// Of the mean stress; NaN where it is not known.
double stress_half_width(const ClothSource& s) {
  for (const RunQuantity& q : cloth_quantities(s.whole, s.history))
    if (q.name == names::stress) return q.half_width().value_or(std::nan(""));
  return std::nan("");
}

Json scaled(double value, const std::optional<Scales>& scale) {
  return scale ? Json(value / scale->stress) : Json();
}

/// The scatter in each whole cycle, about the centre over all of them.
Json of_cycles(const ClothSource& s, double (Scatter::*scatter)(const Scatter&) const) {
  Json values = Json::array();
  for (const Scatter& cycle : s.statistics.cycles())
    values.push_back((cycle.*scatter)(s.all.scatter));
  return values;
}

/// Of a phase [s].
template <Phase phase>
Json seconds(const RunSource& s) {
  return s.end.phases[static_cast<std::size_t>(phase)];
}

/// The same over the sum of all.
template <Phase phase>
Json share(const RunSource& s) {
  const double all = std::accumulate(s.end.phases.begin(), s.end.phases.end(), 0.0);
  return all > 0 ? Json(s.end.phases[static_cast<std::size_t>(phase)] / all) : Json();
}

}  // namespace

namespace entries {

const std::vector<DeclaredEntry<TopSource>> top = {
    {{"title", pure_number, "of the case"},
     [](const TopSource& s) -> Json { return s.whole.title; }},
    {{"window", second, "of the statistics, from begin to end, as the case has it"},
     [](const TopSource& s) -> Json {
       return {s.whole.output.window_begin, s.whole.output.window_end};
     }},
    {{"statistics over", second,
      "the span that they rest on: the whole cycles of the drive within "
      "the window that the run has covered; where there is none, or no "
      "period, what it has covered of the window"},
     [](const TopSource& s) -> Json {
       return {s.span.over.begin, s.span.over.end};
     }},
    {{"whole cycles", pure_number, "that this span holds; 0: it is what is covered"},
     [](const TopSource& s) -> Json { return s.span.cycles; }},
};

const std::vector<DeclaredEntry<RunSource>> run = {
    {{names::outcome, pure_number, "`complete`, `stopped`, or the error that ended the run"},
     [](const RunSource& s) -> Json { return s.end.outcome; }},
    {{names::end, second, "time that the run has reached"},
     [](const RunSource& s) -> Json { return s.end.time; }},
    {{names::steps, pure_number, "since the start"},
     [](const RunSource& s) -> Json { return s.end.steps; }},
    {{names::ranks, pure_number, "processes that computed together"},
     [](const RunSource& s) -> Json { return s.end.ranks; }},
    {{"cells", pure_number, "of the grid"},
     [](const RunSource& s) -> Json { return cells(s.whole); }},
    {{names::wall_time, second, "that the steps took"},
     [](const RunSource& s) -> Json { return s.end.wall_time; }},
    {{names::throughput, pure_number, "cells times steps over wall time"},
     [](const RunSource& s) -> Json {
       return 1e-6 * cells(s.whole) * static_cast<double>(s.end.steps) / s.end.wall_time;
     }},
    {{names::largest_step, second, "of time"},
     [](const RunSource& s) -> Json { return s.end.extremes.largest_step; }},
    {{names::smallest_step, second, "of time"},
     [](const RunSource& s) -> Json {
       return s.end.steps > 0 ? Json(s.end.extremes.smallest_step) : Json();
     }},
    {{names::largest_courant, pure_number, "of all steps"},
     [](const RunSource& s) -> Json { return s.end.extremes.courant; }},
    {{names::largest_divergence, pure_number,
      "of all steps: of the water, times the cell h over the largest speed U; root mean square, or "
      "a hundredth of the largest cell's where that is more"},
     [](const RunSource& s) -> Json { return s.end.extremes.divergence; }},
    {{"pressure cycles per step", pure_number, "of the pressure solver"},
     [](const RunSource& s) -> Json {
       return per_step(static_cast<double>(s.end.extremes.cycles), s);
     }},
    {{names::unconverged, pure_number, "steps whose pressure did not reach its bound"},
     [](const RunSource& s) -> Json { return s.end.extremes.unconverged; }},
    {{"frames", pure_number, "written"}, [](const RunSource& s) -> Json { return s.end.frames; }},
    {{"commit", pure_number, "of the source; `-dirty` where it was changed since"},
     [](const RunSource&) -> Json { return build_facts().commit; }},
    {{"compiler", pure_number, "that built the program"},
     [](const RunSource&) -> Json { return build_facts().compiler; }},
    {{"built for", pure_number, "processor that the build was asked for"},
     [](const RunSource&) -> Json { return build_facts().target; }},
    {{"instruction set", pure_number, "widest vector instructions that the build may use"},
     [](const RunSource&) -> Json { return build_facts().instructions; }},
    {{"vector width", {"bit"}, "of these"},
     [](const RunSource&) -> Json { return build_facts().vector_width; }},
    {{"processor", pure_number, "that the run was on; results of a chaotic flow depend on it"},
     [](const RunSource&) -> Json { return processor(); }},
};

const std::vector<DeclaredEntry<RunSource>> phases = {
    {{"solids", second, "moved, and their faces closed or opened, Eq. (9)"},
     seconds<Phase::solids>},
    {{"solids, share", pure_number, "of the time in all phases"}, share<Phase::solids>},
    {{"prediction", second, "of the velocity without pressure and cloth, Eq. (1)"},
     seconds<Phase::prediction>},
    {{"prediction, share", pure_number, "of the time in all phases"}, share<Phase::prediction>},
    {{"cloth", second, "its forces, its solve and its contacts with solids, Eqs. (4) and (6)"},
     seconds<Phase::cloth>},
    {{"cloth, share", pure_number, "of the time in all phases"}, share<Phase::cloth>},
    {{"contact", second, "of cloth with cloth"}, seconds<Phase::contact>},
    {{"contact, share", pure_number, "of the time in all phases"}, share<Phase::contact>},
    {{"exchange", second, "of force and velocity between cloth and water, Eqs. (3) and (5)"},
     seconds<Phase::exchange>},
    {{"exchange, share", pure_number, "of the time in all phases"}, share<Phase::exchange>},
    {{"projection", second, "by the pressure, Eq. (2)"}, seconds<Phase::projection>},
    {{"projection, share", pure_number, "of the time in all phases"}, share<Phase::projection>},
    {{"loads", second, "of the water on solids that turn"}, seconds<Phase::loads>},
    {{"loads, share", pure_number, "of the time in all phases"}, share<Phase::loads>},
    {{"rows and frames", second, "with the measures in them"}, seconds<Phase::output>},
    {{"rows and frames, share", pure_number, "of the time in all phases"}, share<Phase::output>},
    {{"checkpoints", second, "and what is kept in memory to try a step again"},
     seconds<Phase::checkpoints>},
    {{"checkpoints, share", pure_number, "of the time in all phases"}, share<Phase::checkpoints>},
    {{"rest", second, "setting up, the watch over the run, the log"}, seconds<Phase::rest>},
    {{"rest, share", pure_number, "of the time in all phases"}, share<Phase::rest>},
};

const std::vector<DeclaredEntry<RunSource>> coupling = {
    {{"newton steps per step", pure_number, "of the cloth's solver"},
     [](const RunSource& s) -> Json {
       return per_step(static_cast<double>(s.end.extremes.newton), s);
     }},
    {{names::strain, pure_number, "of an edge of the cloth in all steps, Green's, its magnitude"},
     [](const RunSource& s) -> Json { return s.end.extremes.strain; }},
    {{"largest rms slip", metre_per_second,
      "of the cloth against the water; looked at in each row and eighth step"},
     [](const RunSource& s) -> Json { return s.end.extremes.slip; }},
    {{names::mean_slip_share, pure_number, "over these steps"},
     [](const RunSource& s) -> Json {
       const auto& e = s.end.extremes;
       return e.sum_of_slip_shares / static_cast<double>(e.slip_looks);
     }},
    {{names::largest_slip_share, pure_number, "of these steps"},
     [](const RunSource& s) -> Json { return s.end.extremes.slip_share; }},
    {{names::depth, metre, "in a step, had nothing held it off"},
     [](const RunSource& s) -> Json { return s.end.extremes.depth; }},
    {{names::penetration, metre, "that a node of the cloth had at the end of a step"},
     [](const RunSource& s) -> Json { return s.end.extremes.penetration; }},
    {{"nodes held off solids per step", pure_number, "of the cloth"},
     [](const RunSource& s) -> Json {
       return per_step(static_cast<double>(s.end.extremes.touched), s);
     }},
    {{"pairs of cloth held apart per step", pure_number,
      "nodes and faces, or two edges, that would have come nearer than contact.gap"},
     [](const RunSource& s) -> Json {
       return per_step(static_cast<double>(s.end.extremes.held), s);
     }},
    {{"pieces cut short", pure_number,
      "in all steps: that went a part of their way only, so as not to pass through cloth"},
     [](const RunSource& s) -> Json { return s.end.extremes.cut; }},
};

namespace {

/// Null where water passes the sides, and no balance of energy is kept.
Json of_balance(const RunSource& s, double value) {
  return is_closed(s.whole) ? Json(value) : Json();
}

Json if_finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

/// Null where there is no cloth.
Json of_crossings(const RunSource& s, Json value) {
  return s.whole.cloth.empty() ? Json() : std::move(value);
}

}  // namespace

const std::vector<DeclaredEntry<RunSource>> quality = {
    {{"largest grid scale", pure_number,
      "share of the water's kinetic energy that alternates from cell to cell, along the axis where "
      "it is largest; above 0.15 the grid does not resolve the flow, white noise has 0.375"},
     [](const RunSource& s) -> Json { return s.end.quality.worst.grid_scale; }},
    {{"largest speed over driving speed", pure_number,
      "of the water over the fastest surface, side or inflow; above 3 the grid does not resolve "
      "the "
      "flow"},
     [](const RunSource& s) -> Json { return s.end.quality.worst.speed_ratio(); }},
    {{"driving speed", metre_per_second, "of the fastest surface, side or inflow"},
     [](const RunSource& s) -> Json { return s.end.quality.worst.driving_speed; }},
    {{"work", joule,
      "of drives and moving sides on water and cloth, and of weight, load, and repulsion with "
      "its friction on cloth; "
      "where no water passes the sides"},
     [](const RunSource& s) { return of_balance(s, s.end.quality.balance.work); }},
    {{"gain of energy", joule, "kinetic of the water; elastic and kinetic of the cloth"},
     [](const RunSource& s) { return of_balance(s, s.end.quality.balance.gain); }},
    {{"heat", joule, "made by viscosity"},
     [](const RunSource& s) { return of_balance(s, s.end.quality.balance.heat); }},
    {{"energy residual", joule,
      "work less gain and heat: what the scheme, loss of the cloth, and friction on solids and in "
      "held pairs take out of the motion"},
     [](const RunSource& s) { return of_balance(s, s.end.quality.balance.rest()); }},
    {{"energy residual over work or heat", pure_number, "whichever is larger"},
     [](const RunSource& s) { return of_balance(s, s.end.quality.balance.share()); }},
    {{"edges of cloth", pure_number, "between neighbouring nodes"},
     [](const RunSource& s) { return of_crossings(s, s.end.quality.crossings.edges); }},
    {{"most edges through other pieces", pure_number, "in a frame"},
     [](const RunSource& s) { return of_crossings(s, s.end.quality.most_crossings); }},
    {{"share of edges through other pieces", pure_number, "in the last frame"},
     [](const RunSource& s) { return of_crossings(s, s.end.quality.crossings.share()); }},
    {{"most edges through their own piece", pure_number, "in a frame"},
     [](const RunSource& s) { return of_crossings(s, s.end.quality.most_own_crossings); }},
    {{"smallest gap between pieces", metre,
      "in a frame, where it is below 1.5 lateral cells; none if it never is"},
     [](const RunSource& s) { return if_finite(s.end.quality.gap); }},
    {{"smallest gap within a piece", metre,
      "likewise, of two parts that are more than 2.25 lateral cells apart along it"},
     [](const RunSource& s) { return if_finite(s.end.quality.own_gap); }},
    {{"still near a quarter of a cycle later", pure_number,
      "of the pairs of nodes of different pieces less than 1.5 lateral cells apart, over all "
      "frames that come a quarter of a cycle after another one"},
     [](const RunSource& s) { return if_finite(s.end.quality.still_near[0]); }},
    {{"still near a cycle later", pure_number, "likewise"},
     [](const RunSource& s) { return if_finite(s.end.quality.still_near[1]); }},
};

const std::vector<DeclaredEntry<Scales>> scales = {
    {{"sigma_o", pascal, "of stress: density r_o^2 omega_max^2"},
     [](const Scales& s) -> Json { return s.stress; }},
    {{"tau_o", newton_metre, "of torque: sigma_o r_o^2 H"},
     [](const Scales& s) -> Json { return s.torque; }},
};

const std::vector<DeclaredEntry<StressSource>> stress = {
    {{"mean", pascal, "over time, the area of each piece, and the pieces"},
     [](const StressSource& s) -> Json { return s.stress.mean; }},
    {{"standard deviation over time", pascal, "of the mean over all pieces"},
     [](const StressSource& s) -> Json { return s.stress.over_time; }},
    {{"standard deviation over pieces", pascal, "of the pieces' means over time"},
     [](const StressSource& s) -> Json { return s.stress.over_pieces; }},
    {{"standard deviation over pieces and time", pascal, "of all pieces at all times together"},
     [](const StressSource& s) -> Json { return s.stress.over_time_pieces; }},
    {{"mean / sigma_o", pure_number, "the same over the scale of stress, where there is one"},
     [](const StressSource& s) { return scaled(s.stress.mean, s.scale); }},
    {{"standard deviation over time / sigma_o", pure_number, "likewise"},
     [](const StressSource& s) { return scaled(s.stress.over_time, s.scale); }},
    {{"standard deviation over pieces / sigma_o", pure_number, "likewise"},
     [](const StressSource& s) { return scaled(s.stress.over_pieces, s.scale); }},
    {{"standard deviation over pieces and time / sigma_o", pure_number, "likewise"},
     [](const StressSource& s) { return scaled(s.stress.over_time_pieces, s.scale); }},
};

const std::vector<DeclaredEntry<ClothSource>> cloth = {
    {{"pieces", pure_number, "of cloth"},
     [](const ClothSource& s) -> Json { return piece_count(s.whole); }},
    {{"stress, 95 % half width", pascal,
      "the true mean is within +- this with 95 % confidence, "
      "from the means of the cycles"},
     [](const ClothSource& s) -> Json { return stress_half_width(s); }},
    {{"stress, 95 % half width / sigma_o", pure_number,
      "the same over the scale of stress, where there "
      "is one"},
     [](const ClothSource& s) { return scaled(stress_half_width(s), washtub::scales(s.whole)); }},
    {{names::common_scatter, metre,
      "rms distance of all points of the cloth, in (r, z), from the "
      "mean over all pieces and the time"},
     [](const ClothSource& s) -> Json { return s.all.scatter.common(); }},
    {{names::own_scatter, metre, "of the points of each piece from its own mean over the time"},
     [](const ClothSource& s) -> Json { return s.all.scatter.own(); }},
    {{names::common_scatter_cycles, metre, "list, about the same centre"},
     [](const ClothSource& s) { return of_cycles(s, &Scatter::common_about); }},
    {{names::own_scatter_cycles, metre, "list, about the same centres"},
     [](const ClothSource& s) { return of_cycles(s, &Scatter::own_about); }},
    {{"centre (r, z)", metre, "mean over all points of the cloth and the time"},
     [](const ClothSource& s) -> Json {
       return {s.all.scatter.centre()[0], s.all.scatter.centre()[1]};
     }},
};

const std::vector<DeclaredEntry<LoopSource>> loop = {
    {{"mean swept area",
      {"m^2"},
      "by the line from a piece's mean place to its centre; positive: "
      "out at the bottom, up at the wall"},
     [](const LoopSource& s) -> Json { return s.area; }},
    {{"mean turns", pure_number, "of a piece's centre about its mean place"},
     [](const LoopSource& s) -> Json { return s.turns; }},
    {{"rise at the wall", metre_per_second, "mean velocity of the centres beyond 0.7 r_o"},
     [](const LoopSource& s) -> Json { return s.map.wall_rise().mean(); }},
    {{"rise at the axis", metre_per_second, "within 0.5 r_o"},
     [](const LoopSource& s) -> Json { return s.map.axis_rise().mean(); }},
    {{"outward at the surface", metre_per_second, "above 2/3 H"},
     [](const LoopSource& s) -> Json { return s.map.top_outward().mean(); }},
    {{"outward at the floor", metre_per_second, "below 1/3 H"},
     [](const LoopSource& s) -> Json { return s.map.bottom_outward().mean(); }},
    {{"signs agreeing with the wash loop, of 4", pure_number,
      "up at the wall, in at the surface, down "
      "at the axis, out at the floor"},
     [](const LoopSource& s) -> Json { return s.map.agreeing(); }},
};

}  // namespace entries
}  // namespace washtub
