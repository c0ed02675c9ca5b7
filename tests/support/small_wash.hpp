#pragma once
#include <string>

namespace washtub::testing {

/// A case file: a plane washer that turns with a period of 0.1 s, with three pieces of cloth that
/// start at random. `begin` and `end`: of the statistics' window, and the end of the run [s].
inline std::string small_wash(const std::string& begin, const std::string& end) {
  return R"(dimension = 2
[washer]
radius = "0.3 m"
stroke = { kind = "sinusoid", peak = "12 rad/s", frequency = "10 Hz" }
[fluid]
viscosity = "1 Pa s"
[domain]
cells = 32
[cloth]
count = 3
size = ["0.15 m"]
stretch_stiffness = "1e5 N/m"
bending_stiffness = "1e-5 N m"
excess_mass = "0.1 kg/m^2"
thickness = "0.2 mm"
[time]
end = ")" +
         end + R"( s"
[output]
every = "2 ms"
window = [")" +
         begin + R"( s", ")" + end + R"( s"]
)";
}

}  // namespace washtub::testing
