#pragma once
#include <span>
#include <vector>

#include "measure/statistics.hpp"

namespace washtub {

/// What a turning solid did between two samples.
struct TorqueSample {
  Interval over;       ///< [s]
  double impulse = 0;  ///< angular momentum that the solid gave to the water [N m s]
  double speed = 0;    ///< its mean angular speed, angle swept over time [rad/s]
};

/// Work done on the water within the window [J]: the integral of torque times speed, taken as
/// impulse times mean speed of each sample. Its error is of second order in the sample interval. A
/// sample partly inside counts in proportion.
double work(std::span<const TorqueSample> samples, const Interval& window);

/// Work per covered time of the window [W]; NaN if the samples do not touch it.
double mean_power(std::span<const TorqueSample> samples, const Interval& window);

/// Work of every whole cycle of the window, first one from its begin [J]; a cycle that the samples
/// do not cover is left out. Samples in order of time, without gaps.
std::vector<double> energy_per_cycle(std::span<const TorqueSample> samples, const Interval& window,
                                     double period);

}  // namespace washtub
