#include "record/columns.hpp"
#include "record/names.hpp"

namespace washtub {

namespace columns {

constexpr Plot stress_plot(const char* curve, const char* statistic) {
  return {.fold = "Cloth",
          .title = "Stress",
          .axis = "stress",
          .curve = curve,
          .scale = Scale::stress,
          .statistic = statistic};
}

constexpr Plot group_plot(const char* curve, const char* statistic) {
  Plot plot = stress_plot(curve, statistic);
  plot.title = "Stress of";
  return plot;
}

constexpr Plot quantile_plot(const char* curve, const char* statistic) {
  Plot plot = stress_plot(curve, statistic);
  plot.title = "Stress that parts of the cloth stay below";
  return plot;
}

constexpr Plot group_quantile_plot(const char* curve, const char* statistic) {
  Plot plot = stress_plot(curve, statistic);
  plot.title = "Stress that parts stay below, of";
  return plot;
}

constexpr Plot cycles_plot(const char* curve, const char* statistic) {
  return {.fold = "Cloth",
          .title = "Strain cycles",
          .axis = "strain cycles",
          .curve = curve,
          .statistic = statistic};
}

constexpr Plot group_cycles_plot(const char* curve, const char* statistic) {
  Plot plot = cycles_plot(curve, statistic);
  plot.title = "Strain cycles of";
  return plot;
}

constexpr Plot torque_plot(const char* curve) {
  return {.fold = "Torque and energy",
          .title = "Torque on",
          .axis = "torque",
          .curve = curve,
          .scale = Scale::torque,
          .shown = false};
}

constexpr Plot force_plot(const char* axis) {
  return {.fold = "Forces", .title = "Force on", .axis = "force", .curve = axis};
}

constexpr Plot error_plot(const char* curve) {
  return {.fold = "Error against the exact solution",
          .title = "Velocity error",
          .axis = "error",
          .curve = curve,
          .logarithmic = true};
}

constexpr Plot numerics(const char* title, const char* axis) {
  return {.fold = "Numerics", .title = title, .axis = axis, .curve = axis};
}

constexpr Plot iterations(const char* curve) {
  return {.fold = "Numerics", .title = "Iterations", .axis = "iterations", .curve = curve};
}

constexpr Plot probe_plot{.fold = "Probes"};

const std::vector<DeclaredColumn<Sample>> run = {
    {{names::time, second, "since the start"},
     [](const Sample& s) { return s.time; },
     {.fold = ""}},
    {{names::step, pure_number, "steps since the start"},
     [](const Sample& s) { return s.step.number; },
     {.fold = ""}},
    {{names::time_step, second, "length of the last step"},
     [](const Sample& s) { return s.step.length; },
     numerics("Time step", "time step")},
    {{names::courant, pure_number,
      "Courant number of the last step: the largest sum over the axes of "
      "velocity times step over cell"},
     [](const Sample& s) { return s.step.courant; },
     numerics("Courant number", "Courant number")},
    {{names::divergence, pure_number,
      "divergence of the water, times the cell h over the largest speed U: root mean square, or a "
      "hundredth of the largest where that is more"},
     [](const Sample& s) { return s.step.divergence; },
     {.fold = "Numerics",
      .title = "Divergence",
      .axis = "divergence × h/U",
      .curve = "divergence",
      .logarithmic = true}},
    {{"pressure cycles", pure_number, "of the pressure solver in the last step"},
     [](const Sample& s) { return s.step.cycles; },
     iterations("pressure cycles")},
    {{names::speed, metre_per_second, "largest component of the water's velocity"},
     [](const Sample& s) { return s.step.speed; },
     {.fold = "Water", .title = "Largest speed", .axis = "speed", .curve = "speed"}},
    {{names::kinetic_energy, joule, "of the water"},
     [](const Sample& s) { return s.step.kinetic; },
     {.fold = "Water",
      .title = "Kinetic energy",
      .axis = "kinetic energy",
      .curve = "kinetic energy"}},
    {{"grid scale", pure_number,
      "share of the water's kinetic energy that alternates from cell to cell, along the axis where "
      "it is largest; above 0.15 the grid does not resolve the flow, white noise has 0.375"},
     [](const Sample& s) { return s.quality.resolution.grid_scale; },
     numerics("Energy at the grid's scale", "grid scale")},
    {{"speed over driving speed", pure_number,
      "the largest speed of the water over that of the fastest surface, side or inflow; 0 where "
      "there is none"},
     [](const Sample& s) { return s.quality.resolution.speed_ratio(); },
     numerics("Speed over driving speed", "speed over driving speed")},
};

const std::vector<DeclaredColumn<Sample>> energy = {
    {{"dissipation", watt, "rate at which viscosity turns the water's energy into heat"},
     [](const Sample& s) { return s.quality.dissipation; },
     {.fold = "Water", .title = "Dissipation", .axis = "power", .curve = "dissipation"}},
    {{"energy residual", watt,
      "work of drives, sides and forces on cloth less the water's heat and the gain of energy "
      "since the row before: "
      "what the scheme, loss of the cloth, and friction on solids and in held pairs take out of "
      "the "
      "motion"},
     [](const Sample& s) { return s.quality.residual; },
     numerics("Energy residual", "energy residual")},
};

const std::vector<DeclaredColumn<SolidSample>> solid = {
    {{names::torque, newton_metre,
      "of the water and the cloth on it; of a solid that turns the "
      "mean over the steps since the row before, of one at rest at "
      "the instant"},
     [](const SolidSample& s) { return s.torque; },
     {.fold = "Torque and energy",
      .title = "Torque on",
      .axis = "torque",
      .curve = "total",
      .scale = Scale::torque,
      .instants = true}},
    {{names::rms_torque, newton_metre,
      "root of the mean square of the torque over the steps since "
      "the row before",
      When::moving},
     [](const SolidSample& s) { return s.rms_torque; },
     {.fold = "Torque and energy",
      .title = "Torque on",
      .axis = "torque",
      .curve = "rms over the steps",
      .scale = Scale::torque,
      .shown = false,
      .statistic = names::rms_torque}},
    {{names::friction, newton_metre, "the part of skin friction at the instant"},
     [](const SolidSample& s) { return s.friction; },
     torque_plot("friction")},
    {{names::pressure, newton_metre, "the part of the pressure at the instant"},
     [](const SolidSample& s) { return s.pressure; },
     torque_plot("pressure")},
    {{names::convection, newton_metre,
      "momentum carried into the steps of the cells at the "
      "instant"},
     [](const SolidSample& s) { return s.convection; },
     torque_plot("convection")},
    {{names::power, watt,
      "given to the water: minus torque times speed, mean over the steps since "
      "the row before",
      When::moving},
     [](const SolidSample& s) { return s.power; },
     {.fold = "Torque and energy",
      .title = "Power of",
      .axis = "power",
      .curve = "power",
      .statistic = names::mean_power,
      .integral = "Energy per cycle of",
      .integral_statistic = names::energy}},
    {{"speed", {"rad/s"}, "mean since the row before", When::moving},
     [](const SolidSample& s) { return s.speed; },
     {.fold = "Torque and energy", .title = "Speed of", .axis = "angular speed", .curve = "speed"}},
    {{"angle", {"rad"}, "swept since the start", When::moving},
     [](const SolidSample& s) { return s.angle; }},
    {{"force x", newton, "of the water on it at the instant"},
     [](const SolidSample& s) { return s.force.x(); },
     force_plot("x")},
    {{"force y", newton, "of the water on it at the instant"},
     [](const SolidSample& s) { return s.force.y(); },
     force_plot("y")},
    {{"force z", newton, "of the water on it at the instant", When::space},
     [](const SolidSample& s) { return s.force.z(); },
     force_plot("z")},
};

const std::vector<DeclaredColumn<Sample>> error = {
    {{"largest velocity error", metre_per_second,
      "largest difference of a velocity component from "
      "the case's exact one"},
     [](const Sample& s) { return s.error.largest; },
     error_plot("largest")},
    {{"rms velocity error", metre_per_second, "root of the mean square of these differences"},
     [](const Sample& s) { return s.error.rms; },
     error_plot("rms")},
};

const std::vector<DeclaredColumn<Sample>> cloth = {
    {{names::stress, pascal,
      "largest at the surfaces of the cloth (von Mises in 3-D), with membrane strains low-passed "
      "over output.stress_time; mean over the area of each piece, then over the pieces"},
     [](const Sample& s) { return s.stress.total; },
     stress_plot("total", names::stress)},
    {{names::membrane_stress, pascal, "the part of stretching and shear, mean as the stress"},
     [](const Sample& s) { return s.stress.membrane; },
     stress_plot("membrane", names::membrane_stress)},
    {{names::bending_stress, pascal, "the part of bending and twisting, mean as the stress"},
     [](const Sample& s) { return s.stress.bending; },
     stress_plot("bending", names::bending_stress)},
    {{names::tension, pascal,
      "the membrane stress along edges that are stretched, those that are not counting as 0; mean "
      "as the stress"},
     [](const Sample& s) { return s.tension; },
     stress_plot("tension", names::tension)},
    {{names::compression, pascal, "the same of edges that are compressed, its magnitude"},
     [](const Sample& s) { return s.compression; },
     stress_plot("compression", names::compression)},
    {{names::raw_stress, pascal,
      "the stress with the strains of the instant: elastic waves, which depend on the time step, "
      "count in full"},
     [](const Sample& s) { return s.raw_stress; },
     stress_plot("raw", names::raw_stress)},
    {{names::stress_50, pascal, "that 50 % of the cloth's area stay below at the instant"},
     [](const Sample& s) { return s.quantiles[0]; },
     quantile_plot("50 %", names::stress_50)},
    {{names::stress_90, pascal, "that 90 % of the cloth's area stay below at the instant"},
     [](const Sample& s) { return s.quantiles[1]; },
     quantile_plot("90 %", names::stress_90)},
    {{names::stress_99, pascal, "that 99 % of the cloth's area stay below at the instant"},
     [](const Sample& s) { return s.quantiles[2]; },
     quantile_plot("99 %", names::stress_99)},
    {{names::strain_cycles_small, per_second,
      "how often an edge of the cloth goes to and fro by at least 0.1 % of strain (rainflow count "
      "of the low-passed strain at every step), per edge; since the row before"},
     [](const Sample& s) { return s.strain_cycles[0]; },
     cycles_plot("over 0.1 %", names::strain_cycles_small)},
    {{names::strain_cycles_middle, per_second, "the same from 1 % on"},
     [](const Sample& s) { return s.strain_cycles[1]; },
     cycles_plot("over 1 %", names::strain_cycles_middle)},
    {{names::strain_cycles_large, per_second, "the same from 5 % on"},
     [](const Sample& s) { return s.strain_cycles[2]; },
     cycles_plot("over 5 %", names::strain_cycles_large)},
    {{names::radius, metre, "distance of the pieces' centres from the axis, mean over the area"},
     [](const Sample& s) { return s.centre[0]; },
     {.fold = "Cloth",
      .title = "Radius of the cloth",
      .axis = "radius",
      .curve = "radius",
      .statistic = names::radius}},
    {{names::height, metre, "of the pieces' centres, mean over the area", When::space},
     [](const Sample& s) { return s.centre[1]; },
     {.fold = "Cloth",
      .title = "Height of the cloth",
      .axis = "height",
      .curve = "height",
      .statistic = names::height}},
    {{names::strain, pure_number, "of an edge of the cloth, Green's, its magnitude"},
     [](const Sample& s) { return s.step.strain; },
     numerics("Largest strain", "strain")},
    {{names::slip, metre_per_second, "of the cloth against the water, rms over the nodes"},
     [](const Sample& s) { return s.step.slip; },
     numerics("Slip", "rms slip")},
    {{"newton steps", pure_number, "of the cloth's solver in the last step"},
     [](const Sample& s) { return s.step.newton; },
     iterations("Newton steps of the cloth")},
};

const std::vector<DeclaredColumn<Vec<3>>> probe = {
    {{"x", metre, "place of the probe's node"}, [](const Vec<3>& x) { return x.x(); }, probe_plot},
    {{"y", metre, "place of the probe's node"}, [](const Vec<3>& x) { return x.y(); }, probe_plot},
    {{"z", metre, "place of the probe's node", When::space},
     [](const Vec<3>& x) { return x.z(); },
     probe_plot},
};

const std::vector<DeclaredColumn<Sample>> rings = {
    {{"enclosed area", {"m^2"}, "within a ring, mean over the rings"},
     [](const Sample& s) { return s.enclosed_area; },
     {.fold = "Cloth", .title = "Enclosed area", .axis = "area", .curve = "area"}},
};

const std::vector<DeclaredColumn<PieceSample>> group = {
    {{names::stress, pascal, "mean over the pieces of the group"},
     [](const PieceSample& p) { return p.stress.total; },
     group_plot("total", names::stress)},
    {{names::membrane_stress, pascal, "its part of stretching and shear"},
     [](const PieceSample& p) { return p.stress.membrane; },
     group_plot("membrane", names::membrane_stress)},
    {{names::bending_stress, pascal, "its part of bending and twisting"},
     [](const PieceSample& p) { return p.stress.bending; },
     group_plot("bending", names::bending_stress)},
    {{names::tension, pascal, "the membrane stress along edges that are stretched"},
     [](const PieceSample& p) { return p.tension; },
     group_plot("tension", names::tension)},
    {{names::compression, pascal, "the same of edges that are compressed"},
     [](const PieceSample& p) { return p.compression; },
     group_plot("compression", names::compression)},
    {{names::raw_stress, pascal, "the stress with the strains of the instant"},
     [](const PieceSample& p) { return p.raw_stress; },
     group_plot("raw", names::raw_stress)},
    {{names::stress_50, pascal, "that 50 % of the group's area stay below at the instant"},
     [](const PieceSample& p) { return p.quantiles[0]; },
     group_quantile_plot("50 %", names::stress_50)},
    {{names::stress_90, pascal, "that 90 % of the group's area stay below at the instant"},
     [](const PieceSample& p) { return p.quantiles[1]; },
     group_quantile_plot("90 %", names::stress_90)},
    {{names::stress_99, pascal, "that 99 % of the group's area stay below at the instant"},
     [](const PieceSample& p) { return p.quantiles[2]; },
     group_quantile_plot("99 %", names::stress_99)},
    {{names::strain_cycles_small, per_second, "of its edges, as of all cloth"},
     [](const PieceSample& p) { return p.strain_cycles[0]; },
     group_cycles_plot("over 0.1 %", names::strain_cycles_small)},
    {{names::strain_cycles_middle, per_second, "likewise"},
     [](const PieceSample& p) { return p.strain_cycles[1]; },
     group_cycles_plot("over 1 %", names::strain_cycles_middle)},
    {{names::strain_cycles_large, per_second, "likewise"},
     [](const PieceSample& p) { return p.strain_cycles[2]; },
     group_cycles_plot("over 5 %", names::strain_cycles_large)},
    {{names::radius, metre, "distance of the pieces' centres from the axis, their mean"},
     [](const PieceSample& p) { return p.centre[0]; },
     {.fold = "Cloth",
      .title = "Radius of",
      .axis = "radius",
      .curve = "radius",
      .statistic = names::radius}},
    {{names::height, metre, "of the pieces' centres, their mean", When::space},
     [](const PieceSample& p) { return p.centre[1]; },
     {.fold = "Cloth",
      .title = "Height of",
      .axis = "height",
      .curve = "height",
      .statistic = names::height}},
};

const std::vector<DeclaredColumn<PieceSample>> piece = {
    {{names::piece_r, metre, "distance of the piece's centre from the axis"},
     [](const PieceSample& p) { return p.centre[0]; }},
    {{names::piece_z, metre, "height of the piece's centre; 0 in 2-D"},
     [](const PieceSample& p) { return p.centre[1]; }},
    {{names::stress, pascal, "largest at the surfaces of the cloth, mean over the piece's area"},
     [](const PieceSample& p) { return p.stress.total; }},
};

}  // namespace columns

}  // namespace washtub
