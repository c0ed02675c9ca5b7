#include "record/summarise.hpp"

#include "case/groups.hpp"
#include "measure/cycles.hpp"
#include "measure/energy.hpp"

namespace washtub {
namespace {

using Json = nlohmann::ordered_json;

Json stress_part(const StressSummary& s, const std::optional<Scales>& scale) {
  Json j = {{"mean [Pa]", s.mean},
            {"standard deviation over time [Pa]", s.over_time},
            {"standard deviation over pieces [Pa]", s.over_pieces},
            {"standard deviation over pieces and time [Pa]", s.over_time_pieces}};
  if (!scale) return j;
  j["mean / sigma_o"] = s.mean / scale->stress;
  j["standard deviation over time / sigma_o"] = s.over_time / scale->stress;
  j["standard deviation over pieces / sigma_o"] = s.over_pieces / scale->stress;
  j["standard deviation over pieces and time / sigma_o"] = s.over_time_pieces / scale->stress;
  return j;
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

/// A value of every sample, with the times at which they end.
struct Signal {
  template <class Value>
  Signal(const std::vector<Sample>& samples, Value&& value) {
    for (const auto& s : samples) times.push_back(s.time), values.push_back(value(s));
  }
  Statistics over(const Interval& span) const { return over_span(times, values, span); }

  std::vector<double> times, values;
};

Json solid_summary(const std::string& name, const Drive& drive, std::size_t s,
                   const std::vector<Sample>& samples, const Interval& window, const Case& c) {
  const auto rms = [&](auto&& value) {
    return Signal(samples, [&](const Sample& x) { return value(x.solids[s]); }).over(window).rms();
  };
  Json j = {{"name", name},
            {c.dimension == 3 ? "rms torque [N m]" : "rms torque [N m/m]",
             rms([](const SolidSample& x) { return x.torque; })}};
  if (const auto scale = scales(c)) {
    const auto add = [&](const char* key, auto&& value) { j[key] = rms(value) / scale->torque; };
    add("rms torque / tau_o", [](const SolidSample& x) { return x.torque; });
    add("rms skin friction torque / tau_o", [](const SolidSample& x) { return x.friction; });
    add("rms pressure torque / tau_o", [](const SolidSample& x) { return x.pressure; });
    add("rms convective torque / tau_o", [](const SolidSample& x) { return x.convection; });
    add("rms friction and pressure torque / tau_o",
        [](const SolidSample& x) { return x.friction + x.pressure; });
  }
  if (!drive.moving()) return j;
  std::vector<TorqueSample> torques;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const auto& now = samples[i];
    const Interval over{samples[i - 1].time, now.time};
    torques.push_back({over, -now.solids[s].torque * over.length(), now.solids[s].speed});
  }
  j[c.dimension == 3 ? "mean power [W]" : "mean power [W/m]"] = mean_power(torques, window);
  if (drive.period() > 0) {
    const auto cycles = energy_per_cycle(torques, window, drive.period());
    const auto mean = mean_of_batches(cycles);
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

/// The scatter in every whole cycle of the window that the samples have covered, about the centre
/// over the whole window.
template <int D>
std::vector<double> of_cycles(const Observer<D>& observer,
                              double (Scatter::*scatter)(const Scatter&) const) {
  std::vector<double> values;
  for (const Scatter& cycle : observer.scatter_of_cycles())
    if (cycle.window().end < observer.samples().back().time * (1 + 1e-6))
      values.push_back((cycle.*scatter)(observer.scatter()));
  return values;
}

template <int D>
Json cloth_summary(const Simulation<D>& simulation, const Observer<D>& observer) {
  const auto& c = simulation.definition();
  const auto& samples = observer.samples();
  const auto scale = scales(c);
  const Signal stress(samples, [](const Sample& s) { return s.stress.total; });
  std::vector<double> cycles;
  for (const auto& cycle : whole_cycles(observer.window(), samples.back().time, c.scale.period))
    cycles.push_back(stress.over(cycle).mean());
  const auto mean = mean_of_batches(cycles);
  const auto pieces = static_cast<std::size_t>(simulation.cloth().pieces());
  Json j = {
      {"pieces", pieces},
      {"stress", stress_part(observer.stress().total(), scale)},
      {"stress, 95 % half width [Pa]", mean.half_width},
      {"membrane stress", stress_part(observer.stress().membrane(), scale)},
      {"bending stress", stress_part(observer.stress().bending(), scale)},
      {"scatter about the common centre [m]", observer.scatter().common()},
      {"scatter about each piece's own centre [m]", observer.scatter().own()},
      {"scatter about the common centre in each cycle [m]",
       of_cycles(observer, &Scatter::common_about)},
      {"scatter about each piece's own centre in each cycle [m]",
       of_cycles(observer, &Scatter::own_about)},
      {"centre (r, z) [m]", {observer.scatter().centre()[0], observer.scatter().centre()[1]}}};
  if (scale) j["stress, 95 % half width / sigma_o"] = mean.half_width / scale->stress;
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
  if (const auto scale = scales(c))
    j["scales"] = {{"sigma_o [Pa]", scale->stress}, {"tau_o [N m]", scale->torque}};
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
