#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

#include "io/scratch.hpp"
#include "report/run_record.hpp"

namespace washtub::testing {

/// Output directories of a made-up washer that turns with a period of 1 s for 4 s, with one piece
/// of cloth and statistics from 1 s on.
class RunFolder {
 public:
  static std::string case_text(const std::string& more = "") {
    return "title = \"made up\"\n" + more + R"(
[washer]
radius = "0.5 m"
depth = "0.4 m"
stroke = { kind = "sinusoid", peak = "2 rad/s", frequency = "1 Hz" }
[fluid]
viscosity = "1 Pa s"
[domain]
cells = 16
[[cloth]]
size = ["0.1 m", "0.1 m"]
nodes = [5, 5]
stretch_stiffness = "1e4 N/m"
shear_stiffness = "1e2 N/m"
bending_stiffness = "1e-4 N m"
torsion_stiffness = "1e-4 N m"
excess_mass = "0.1 kg/m^2"
thickness = "0.2 mm"
[time]
end = "4 s"
step = "0.01 s"
[output]
every = "0.1 s"
window = ["1 s", "4 s"]
)";
  }

  /// A history to `end` [s] whose stress, torque of the tub and power are these functions of time.
  struct Signals {
    std::function<double(double)> stress = [](double) { return 0.0; };
    std::function<double(double)> torque = [](double) { return 0.0; };
    std::function<double(double)> power = [](double) { return 0.0; };
  };
  static std::string history(const Signals& signals, double end = 4) {
    std::string text =
        "time [s],step,time step [s],courant,divergence,speed [m/s],kinetic energy [J],tub torque "
        "[N m],agitator power [W],agitator torque [N m],stress [Pa],membrane stress [Pa],bending "
        "stress [Pa],largest strain,slip [m/s]\n";
    for (int i = 0; 0.1 * i < end + 1e-9; ++i) {
      const double t = 0.1 * i;
      text += fmt::format("{0},{1},0.01,0.1,1e-5,1,2,{2},{3},5,{4},{4},0,0.01,0.001\n", t, 10 * i,
                          signals.torque(t), signals.power(t), signals.stress(t));
    }
    return text;
  }

  void write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories(std::filesystem::path(path(name)).parent_path());
    std::ofstream(path(name)) << text;
  }
  std::string path(const std::string& name) const { return folder_ / name; }
  /// A whole run: case, history, and a summary that says "complete".
  RunRecord run(const std::string& name, const Signals& signals,
                const std::string& text = case_text()) const {
    write(name + "/case.toml", text);
    write(name + "/history.csv", history(signals));
    write(name + "/tracks.csv", "time [s]\n");
    write(name + "/summary.json", R"({"run": {"outcome": "complete", "steps": 400}})");
    return read_run(path(name));
  }

 private:
  Scratch folder_;
};

}  // namespace washtub::testing
