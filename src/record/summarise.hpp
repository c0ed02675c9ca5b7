#pragma once
#include <nlohmann/json.hpp>

#include "record/observer.hpp"

namespace washtub {

/// summary.json: run facts, and statistics over the window with their uncertainty.
template <int D>
nlohmann::ordered_json summarise(const Simulation<D>& simulation, const Observer<D>& observer,
                                 double wall_time);

}  // namespace washtub
