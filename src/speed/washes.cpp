#include "speed/washes.hpp"

#include <fmt/format.h>

namespace washtub {
namespace {

/// As in cases/wash-3d and cases/wash-2d, for as long as is measured.
constexpr const char* in_space = R"(
[washer]
radius = "31 cm"
depth = "23.76 cm"
[[cloth]]
count = 16
size = ["15 cm", "15 cm"]
stretch_stiffness = "8e5 N/m"
shear_stiffness = "3e2 N/m"
bending_stiffness = "1e-5 N m"
torsion_stiffness = "1e-5 N m"
excess_mass = "9.3e-2 kg/m^2"
thickness = "0.24 mm"
)";
constexpr const char* in_plane = R"(
[washer]
radius = "31.86 cm"
[[cloth]]
count = 20
arrangement = "random"
size = ["17.39 cm"]
clearance = "2.161 cm"
stretch_stiffness = "8e3 N/m"
bending_stiffness = "1e-5 N m"
excess_mass = "9.3e-2 kg/m^2"
thickness = "0.24 mm"
)";
constexpr const char* both = R"(
[washer.stroke]
kind = "sinusoid"
peak = "120 rpm"
frequency = "0.6366197723675814 Hz"
[fluid]
viscosity = "1 Pa s"
[time]
end = "10 s"
)";

}  // namespace

Case reference_wash(int dimension, int cells, bool cloth) {
  std::string text = fmt::format("dimension = {}\n", dimension);
  text += dimension == 3 ? in_space : in_plane;
  text += both;
  text += fmt::format("[domain]\ncells = {}\n", cells);
  return read_case_text(text, "reference wash", {cloth ? "cloth.seed=1" : "cloth.count=0"});
}

}  // namespace washtub
