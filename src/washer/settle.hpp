#pragma once
#include <functional>
#include <vector>

#include "washer/simulation.hpp"

namespace washtub {

/// The case in which the cloth of another one settles: solids and sides rest, so does the water at
/// first, gravity is that of settling, nothing else pulls.
Case settling_case(const Case& whole);

/// How cloth has settled.
template <int D>
struct Settled {
  std::vector<Vec<D>> places;  ///< of the nodes [m]
  double time = 0;             ///< that it took [s]
  double speed = 0;            ///< of the nodes at the end, rms [m/s]
  bool at_rest = false;        ///< it has as good as none
  bool stopped = false;        ///< it was asked to stop; the places then mean nothing
};

/// Lets the cloth of a case settle, until it rests or the time for that is over (collective).
/// `watch` is called after every step, the same on all ranks; where it returns false that is the
/// end. @throws RunError where the cloth or the water makes no sense any more
template <int D>
Settled<D> settle(const Case& whole, const Parallel& parallel,
                  const std::function<bool(const Simulation<D>&)>& watch);

}  // namespace washtub
