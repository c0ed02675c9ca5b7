#pragma once
#include <string>

#include "base/parallel.hpp"
#include "case/case.hpp"

namespace washtub {

/// What a run will take.
struct Forecast {
  double steps = 0;
  double seconds = 0;      ///< of computing, without the page
  double memory = 0;       ///< of all ranks together, at most [B]
  double frames = 0;       ///< on the disk [B]
  double tables = 0;       ///< history and tracks [B]
  double checkpoints = 0;  ///< that stay [B]
  int coarser = 1;         ///< how many times as wide the cells were on which steps were tried
  std::string failure;     ///< why the first steps fail; "" = they do not
};

/// Number of steps of a run, from the speed of what drives it. `driving_speed`: of the fastest
/// surface or side [m/s]; `start_rate`: sum over the axes of |u| / h after the first steps [1/s].
double foresee_steps(const Case& whole, double driving_speed, double start_rate);

/// The run is begun, within some seconds, in a directory that is removed afterwards: what steps,
/// rows, frames and checkpoints take is measured, and multiplied by their number. Cases of more
/// than a million cells are begun on a coarser grid. Collective.
Forecast foresee(const Case& whole, const Parallel& parallel);

}  // namespace washtub
