#pragma once
#include <functional>
#include <vector>

#include "washer/simulation.hpp"

namespace washtub {

/// The case in which the cloth of another one settles: solids and sides rest, so does the water at
/// first, gravity is that of settling, nothing else pulls, steps are `share` of what they would be.
Case settling_case(const Case& whole, double share = 1);

/// How cloth has settled.
template <int D>
struct Settled {
  std::vector<Vec<D>> places;  ///< of the nodes [m]
  double time = 0;             ///< that it took [s]
  double speed = 0;            ///< of the nodes at last, rms [m/s]
  bool at_rest = false;        ///< that is as good as none
  bool stopped = false;        ///< it was asked to stop; the places then mean nothing
};

/// Lets the cloth of a case settle, until it rests or the time for that is over (collective).
/// Whether it rests is looked at fifty times: when it moves ever less, and at less than a twentieth
/// of the speed sqrt(g m/rho) at which its excess mass m per area sinks broadside.
/// `watch` is called after every step, the same on all ranks; where it returns false that is the
/// end. @throws RunError where the cloth or the water makes no sense any more
template <int D>
Settled<D> settle(const Case& whole, const Parallel& parallel,
                  const std::function<bool(const Simulation<D>&)>& watch, double share = 1);

}  // namespace washtub
