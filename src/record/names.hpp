#pragma once

/// Names of outputs that more than their declaration refers to.
namespace washtub::names {

inline constexpr const char* time = "time";
inline constexpr const char* step = "step";
inline constexpr const char* time_step = "time step";
inline constexpr const char* courant = "courant";
inline constexpr const char* divergence = "divergence";
inline constexpr const char* speed = "speed";
inline constexpr const char* kinetic_energy = "kinetic energy";
inline constexpr const char* stress = "stress";
inline constexpr const char* membrane_stress = "membrane stress";
inline constexpr const char* bending_stress = "bending stress";
inline constexpr const char* stress_50 = "stress 50 %";
inline constexpr const char* stress_90 = "stress 90 %";
inline constexpr const char* stress_99 = "stress 99 %";
inline constexpr const char* strain_cycles_small = "strain cycles over 0.1 %";
inline constexpr const char* strain_cycles_middle = "strain cycles over 1 %";
inline constexpr const char* strain_cycles_large = "strain cycles over 5 %";
inline constexpr const char* raw_stress = "raw stress";
inline constexpr const char* tension = "tension";
inline constexpr const char* compression = "compression";
inline constexpr const char* radius = "cloth radius";
inline constexpr const char* height = "cloth height";
inline constexpr const char* strain = "largest strain";
inline constexpr const char* slip = "slip";

inline constexpr const char* power = "power";
inline constexpr const char* torque = "torque";
inline constexpr const char* rms_torque = "rms torque";
inline constexpr const char* friction = "friction torque";
inline constexpr const char* pressure = "pressure torque";
inline constexpr const char* convection = "convection torque";

inline constexpr const char* mean_power = "mean power";
inline constexpr const char* energy = "energy per cycle";

inline constexpr const char* run = "run";
inline constexpr const char* coupling = "coupling";
inline constexpr const char* phases = "phases";
inline constexpr const char* outcome = "outcome";
inline constexpr const char* end = "end";
inline constexpr const char* steps = "steps";
inline constexpr const char* ranks = "ranks";
inline constexpr const char* wall_time = "wall time";
inline constexpr const char* throughput = "million cell-steps per second";
inline constexpr const char* largest_step = "largest step";
inline constexpr const char* smallest_step = "smallest step";
inline constexpr const char* largest_courant = "largest courant number";
inline constexpr const char* largest_divergence = "largest divergence h/U";
inline constexpr const char* unconverged = "unconverged pressure solves";
inline constexpr const char* mean_slip_share = "mean rms slip / largest speed";
inline constexpr const char* largest_slip_share = "largest rms slip / largest speed";
inline constexpr const char* penetration = "deepest penetration of a solid";
inline constexpr const char* depth = "deepest a node would have gone into a solid";
inline constexpr const char* warnings = "warnings";
inline constexpr const char* cloth = "cloth";
inline constexpr const char* common_scatter = "scatter about the common centre";
inline constexpr const char* own_scatter = "scatter about each piece's own centre";
inline constexpr const char* common_scatter_cycles =
    "scatter about the common centre in each cycle";
inline constexpr const char* own_scatter_cycles =
    "scatter about each piece's own centre in each cycle";

inline constexpr const char* velocity = "velocity";
inline constexpr const char* pressure_field = "pressure";
inline constexpr const char* solid = "solid";

inline constexpr const char* piece_r = "r";
inline constexpr const char* piece_z = "z";

}  // namespace washtub::names
