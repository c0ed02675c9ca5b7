#pragma once
#include "base/archive.hpp"

namespace washtub {

/// Largest values and sums over all steps of a run.
struct Extremes {
  double divergence = 0, slip = 0, strain = 0, courant = 0;
  double depth = 0, penetration = 0;              ///< of nodes in solids, if not held, and held [m]
  double slip_share = 0, sum_of_slip_shares = 0;  ///< rms slip over the largest speed then, or
                                                  ///< over the least one that counts
  double speed = 0;                               ///< [m/s]
  long slip_looks = 0;                            ///< steps in which the slip was measured
  long held = 0, cut = 0;                         ///< pairs of cloth, pieces: see Contact::Report
  long touched = 0, cycles = 0, unconverged = 0, newton = 0;
  double largest_step = 0, smallest_step = 1e30;

  void state(Archive& archive) {
    archive.value("divergence", divergence);
    archive.value("slip", slip);
    archive.value("depth", depth);
    archive.value("penetration", penetration);
    archive.value("strain", strain);
    archive.value("courant", courant);
    archive.value("slip share", slip_share);
    archive.value("sum of slip shares", sum_of_slip_shares);
    archive.value("slip looks", slip_looks);
    archive.value("speed", speed);
    archive.value("touched", touched);
    archive.value("held", held);
    archive.value("cut", cut);
    archive.value("pressure cycles", cycles);
    archive.value("unconverged", unconverged);
    archive.value("newton steps", newton);
    archive.value("largest step", largest_step);
    archive.value("smallest step", smallest_step);
  }
};

}  // namespace washtub
