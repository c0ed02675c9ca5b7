#include "case/tables.hpp"

namespace washtub {
namespace {

/// Lets a pair of numbers be read and written as one value.
struct Window {
  double& begin;
  double& end;
  void operator=(const std::array<double, 2>& value) {
    begin = value[0];
    end = value[1];
  }
  operator std::array<double, 2>() const { return {begin, end}; }
};

Window window(OutputCase& output) { return {output.window_begin, output.window_end}; }

}  // namespace

Table<CouplingCase> coupling_table() {
  Table<CouplingCase> table("How cloth and water act on each other.");
  table
      .key("scheme", &CouplingCase::scheme,
           choice<Scheme>({{"implicit", Scheme::implicit},
                           {"explicit", Scheme::explicit_euler},
                           {"broyden", Scheme::broyden}}),
           "implicit cloth with entrained mass; forward Euler, which the paper uses in 3-D; or its "
           "2-D iteration over cloth and water, several pressure solves a step")
      .key(
          "kernel", &CouplingCase::kernel,
          choice<Kernel>(
              {{"cosine", Kernel::cosine}, {"roma3", Kernel::roma3}, {"peskin4", Kernel::peskin4}}),
          "smoothed delta function: of three points, or of four as in the paper")
      .key("marker_spacing", &CouplingCase::marker_spacing, number(between(0.25, 1000)),
           "largest distance between the points where cloth meets water, in shortest cell edges; "
           "1000 leaves only the nodes, as in the paper")
      .key("strain_limit", &CouplingCase::strain_limit, number(above(0)),
           "Green's strain E = (l^2/l_0^2 - 1)/2 of an edge between nodes, either sign, beyond "
           "which "
           "the run stops");
  return table;
}

Table<TimeCase> time_table() {
  Table<TimeCase> table("Time control. The step follows the CFL number, below an upper bound.");
  table.key("end", &TimeCase::end, quantity(measure::time, above(0)), "end of the run")
      .required()
      .key("cfl", &TimeCase::cfl, number({.least = 0, .most = 0.5, .least_excluded = true}),
           "largest advective CFL number")
      .key("step", &TimeCase::step, quantity(measure::time, above(0)),
           "upper bound of the time step")
      .omitted([](const TimeCase& time, int) { return time.step == 0; })
      .fallback("5e-3 / fastest drive [rad/s]; none without a drive")
      .key("fixed", &TimeCase::fixed, boolean(), "take `step` as it is, whatever the CFL number");
  return table;
}

Table<SolverCase> solver_table() {
  Table<SolverCase> table("The pressure solver.");
  table
      .key("divergence", &SolverCase::divergence, number({.least = 1e-14, .most = 1e-1}),
           "stop when |div u| h/U is below this in the root mean square over the water, and below "
           "100 times this in every cell")
      .key("max_cycles", &SolverCase::max_cycles, integer(between(1, 1000)),
           "most multigrid cycles in a step");
  return table;
}

Table<OutputCase> output_table() {
  Table<OutputCase> table("What is written, and when.");
  table
      .key("every", &OutputCase::every, quantity(measure::time, above(0)),
           "interval of the rows of history.csv")
      .fallback("1/200 of the drive's period, or of the run")
      .key("frames", &OutputCase::frames, quantity(measure::time, at_least(0)),
           "interval of the frames; 0 s for none")
      .key("stress_time", &OutputCase::stress_time, quantity(measure::time, at_least(0)),
           "time constant over which the strains behind the stress are low-passed, so that elastic "
           "waves do not count; 0 s for none")
      .key("window", window, interval(measure::time, at_least(0)), "statistics are taken in it")
      .fallback("the whole run");
  return table;
}

Table<CheckpointCase> checkpoint_table() {
  Table<CheckpointCase> table(
      "Checkpoints, from which `washtub run --resume` goes on with a run that was interrupted. One "
      "is written at the end of a run, and when a signal stops it, in any case.");
  table
      .key("every", &CheckpointCase::every, quantity(measure::time, at_least(0)),
           "simulated time between two; 0 s for none")
      .key("wall_time", &CheckpointCase::wall_time, quantity(measure::time, at_least(0)),
           "time of computing between two; 0 s for none")
      .key("keep", &CheckpointCase::keep, integer(between(1, 1000)), "newest ones that stay");
  return table;
}

Table<ScaleCase> scale_table() {
  Table<ScaleCase> table("Scales of the dimensionless groups, Eqs. (17)-(19).");
  table.key("length", &ScaleCase::length, quantity(measure::length, above(0)), "r_o")
      .fallback("tub radius, or half the box's x size")
      .key("speed", &ScaleCase::speed, quantity(measure::angular_speed, at_least(0)),
           "omega_max; 0 rad/s for none")
      .fallback("fastest drive, wall or inflow")
      .key("height", &ScaleCase::height, quantity(measure::length, above(0)), "H")
      .fallback("water depth, or the box's z size; 1 m in 2-D");
  return table;
}

}  // namespace washtub
