#include "app/summarise.hpp"

#include <cmath>

#include "measure/energy.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

/// What the scales of a case make of stresses and torques; 1 where it has none.
struct Scales {
  double stress = 1;  ///< sigma_o [Pa]
  double torque = 1;  ///< tau_o [N m]
};

Scales scales(const Case& c) {
  const double r = c.scale.length, w = c.scale.speed;
  if (r <= 0 || w <= 0) return {};
  const double stress = c.fluid.density * r * r * w * w;
  return {stress, stress * r * r * (c.dimension == 3 ? c.scale.height : 1)};
}

Json stress_part(const StressSummary& s, double scale) {
  return {{"mean [Pa]", s.mean},
          {"standard deviation over time [Pa]", s.over_time},
          {"standard deviation over pieces [Pa]", s.over_pieces},
          {"standard deviation over pieces and time [Pa]", s.over_time_pieces},
          {"mean / sigma_o", s.mean / scale},
          {"standard deviation over time / sigma_o", s.over_time / scale},
          {"standard deviation over pieces / sigma_o", s.over_pieces / scale},
          {"standard deviation over pieces and time / sigma_o", s.over_time_pieces / scale}};
}

/// Samples of the window as one series.
template <class Value>
std::vector<double> series(const std::vector<Sample>& samples, const Interval& window,
                           Value&& value) {
  std::vector<double> out;
  for (const auto& s : samples)
    if (s.time > window.begin && s.time <= window.end * (1 + 1e-12)) out.push_back(value(s));
  return out;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// The whole cycles of the window that the samples cover, and their number; without a period the
/// covered window in eight parts.
std::pair<Interval, std::size_t> whole_cycles(const std::vector<Sample>& samples,
                                              const Interval& window, double period) {
  const double end = std::min(window.end, samples.back().time);
  if (period <= 0) return {{window.begin, end}, 8};
  const double cycles = std::max(0.0, std::floor((end - window.begin) / period + 1e-6));
  return {{window.begin, window.begin + cycles * period}, static_cast<std::size_t>(cycles)};
}

Json solid_summary(const std::string& name, const Drive& drive, std::size_t s,
                   const std::vector<Sample>& samples, const Interval& window, const Case& c) {
  const double tau = scales(c).torque;
  const auto part = [&](double SolidSample::*member) {
    return rms(series(samples, window, [&](const Sample& x) { return x.solids[s].*member; }));
  };
  Json j = {
      {"name", name},
      {c.dimension == 3 ? "rms torque [N m]" : "rms torque [N m/m]", part(&SolidSample::torque)},
      {"rms torque / tau_o", part(&SolidSample::torque) / tau},
      {"rms skin friction torque / tau_o", part(&SolidSample::friction) / tau},
      {"rms pressure torque / tau_o", part(&SolidSample::pressure) / tau},
      {"rms convective torque / tau_o", part(&SolidSample::convection) / tau},
      {"rms friction and pressure torque / tau_o",
       rms(series(samples, window,
                  [&](const Sample& x) { return x.solids[s].friction + x.solids[s].pressure; })) /
           tau}};
  if (!drive.moving()) return j;
  std::vector<TorqueSample> torques;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto& now = samples[i];
    const Interval over{samples[i - 1].time, now.time};
    torques.push_back({over, -now.solids[s].torque * over.length(), now.solids[s].speed});
  }
  j[c.dimension == 3 ? "mean power [W]" : "mean power [W/m]"] = mean_power(torques, window);
  if (drive.period() > 0) {
    const auto cycles = energy_per_cycle(torques, window.begin, drive.period());
    const auto mean = batch_means(cycles, cycles.size());
    const std::string unit = c.dimension == 3 ? " [J]" : " [J/m]";
    j["energy per cycle" + unit] = cycles;
    j["mean energy per cycle" + unit] = mean.mean;
    j["energy per cycle, 95 % half width" + unit] = mean.half_width;
  }
  return j;
}

/// How the pieces go round in (r, z) within the window.
Json loop_summary(const std::vector<Sample>& samples, const Interval& window, const Case& c) {
  const auto times = series(samples, window, [](const Sample& s) { return s.time; });
  const std::size_t pieces = samples.back().centres.size();
  VelocityMap map(c.scale.length > 0 ? c.scale.length : 1, c.scale.height);
  double area = 0, turns = 0;
  for (std::size_t p = 0; p < pieces && times.size() > 1; ++p) {
    std::vector<Vec<2>> track;
    for (const auto& s : samples)
      if (s.time > window.begin && track.size() < times.size()) track.push_back(s.centres[p]);
    map.add(times, track);
    const auto l = loop(times, track);
    area += l.area / static_cast<double>(pieces);
    turns += l.turns / static_cast<double>(pieces);
  }
  return {{"mean swept area [m^2]", area},
          {"mean turns", turns},
          {"rise at the wall [m/s]", map.wall_rise().mean()},
          {"rise at the axis [m/s]", map.axis_rise().mean()},
          {"outward at the surface [m/s]", map.top_outward().mean()},
          {"outward at the floor [m/s]", map.bottom_outward().mean()},
          {"signs agreeing with the wash loop, of 4", map.agreeing()}};
}

template <int D>
Json cloth_summary(const Simulation<D>& simulation, const Observer<D>& observer) {
  const auto& c = simulation.definition();
  const auto& samples = observer.samples();
  const double sigma = scales(c).stress;
  const auto [covered, cycles] = whole_cycles(samples, observer.window(), c.scale.period);
  const auto stress = series(samples, covered, [](const Sample& s) { return s.stress.total; });
  const auto mean = batch_means(stress, cycles);
  const auto pieces = static_cast<std::size_t>(simulation.cloth().pieces());
  Json j = {
      {"pieces", pieces},
      {"stress", stress_part(observer.stress().total(), sigma)},
      {"stress, 95 % half width / sigma_o", mean.half_width / sigma},
      {"membrane stress", stress_part(observer.stress().membrane(), sigma)},
      {"bending stress", stress_part(observer.stress().bending(), sigma)},
      {"scatter about the common centre [m]", observer.scatter().common()},
      {"scatter about each piece's own centre [m]", observer.scatter().own()},
      {"centre (r, z) [m]", {observer.scatter().centre()[0], observer.scatter().centre()[1]}}};
  if constexpr (D == 3) j["loop"] = loop_summary(samples, observer.window(), c);
  return j;
}

}  // namespace

template <int D>
nlohmann::ordered_json summarise(const Simulation<D>& simulation, const Observer<D>& observer,
                                 double wall_time) {
  const auto& c = simulation.definition();
  const auto& e = observer.extremes();
  const auto& last = simulation.last();
  double cells = 1;
  for (int d = 0; d < D; ++d) cells *= c.domain.cells[static_cast<std::size_t>(d)];
  const double steps = static_cast<double>(last.number);
  Json j;
  j["title"] = c.title;
  j["run"] = {{"outcome", ""},
              {"end [s]", last.time},
              {"steps", last.number},
              {"ranks", simulation.grid().parallel().size()},
              {"cells", cells},
              {"wall time [s]", wall_time},
              {"million cell-steps per second", 1e-6 * cells * steps / wall_time},
              {"largest step [s]", e.largest_step},
              {"smallest step [s]", e.smallest_step},
              {"largest courant number", e.courant},
              {"largest divergence h/U", e.divergence},
              {"pressure cycles per step", static_cast<double>(e.cycles) / steps},
              {"unconverged pressure solves", e.unconverged}};
  if (simulation.cloth().pieces() > 0)
    j["coupling"] = {{"newton steps per step", static_cast<double>(e.newton) / steps},
                     {"largest strain", e.strain},
                     {"largest rms slip [m/s]", e.slip},
                     {"mean rms slip / largest speed", e.sum_of_slip_shares / steps},
                     {"largest rms slip / largest speed", e.slip_share},
                     {"deepest penetration of a solid [m]", e.penetration},
                     {"nodes held off solids per step", static_cast<double>(e.touched) / steps}};
  j["window [s]"] = {observer.window().begin, observer.window().end};
  j["scales"] = {{"sigma_o [Pa]", scales(c).stress}, {"tau_o [N m]", scales(c).torque}};
  const auto& solids = simulation.mapping().solids();
  j["solids"] = Json::array();
  for (std::size_t s = 0; s < solids.size(); ++s)
    j["solids"].push_back(solid_summary(solids[s].name, solids[s].drive, s, observer.samples(),
                                        observer.window(), c));
  if (simulation.cloth().pieces() > 0) j["cloth"] = cloth_summary(simulation, observer);
  return j;
}

template nlohmann::ordered_json summarise<2>(const Simulation<2>&, const Observer<2>&, double);
template nlohmann::ordered_json summarise<3>(const Simulation<3>&, const Observer<3>&, double);

}  // namespace washtub
