#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "base/error.hpp"
#include "case/case.hpp"

using namespace washtub;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::StartsWith;

namespace {

/// A value that a key of the input reference does not allow, and what its refusal ends with.
struct Refusal {
  std::string key, value, message;
};

/// Every key, in the order of the input reference.
const std::vector<Refusal> refusals = {
    {"title", "5", "expected a text between quotes"},
    {"dimension", "4", "allowed: 2 or 3"},
    {"washer.radius", R"("0 m")", "allowed: > 0 m"},
    {"washer.depth", R"("-1 cm")", "allowed: > 0 m"},
    {"washer.stroke", R"("120 rpm")", R"(expected a table such as { kind = "rest" })"},
    {"washer.agitator.rim_radius", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.rim_height", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.skirt_top_radius", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.skirt_top_height", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.hub_radius", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.hub_height", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.fin_radius", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.fin_half_thickness", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.fin_root_height", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.fin_tip_height", R"("0 m")", "allowed: > 0 m"},
    {"washer.agitator.fins", "25", "allowed: 0 to 24"},
    {"fluid.density", R"("0 kg/m^3")", "allowed: > 0 kg/m^3"},
    {"fluid.viscosity", R"("1 cP")",
     R"(unknown unit "cP", expected dynamic viscosity such as "1 Pa s")"},
    {"fluid.gravity", R"(["0 m/s", "0 m/s", "1 m/s"])",
     R"(expected acceleration such as "9.81 m/s^2")"},
    {"fluid.velocity", "[0, 0, 0]",
     R"(expected a formula in m/s between quotes such as "2 * x", or "0.2 m/s")"},
    {"domain.lower", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"domain.size", R"(["1 m", "1 m", "0 m"])", "allowed: > 0 m"},
    {"domain.cells", "7", "allowed: 8 to 8192"},
    {"domain.mapping", R"("sharpest")",
     R"(expected one of "sharp", "smooth", "gradual", nearest: "sharp")"},
    {"domain.mapping_width", "0", "allowed: > 0"},
    {"domain.mapping_shift", "0.6", "allowed: 0 to 0.5"},
    {"domain.sides.x_lower", R"("wall")",
     R"(expected one of "no-slip", "slip", "periodic", "moving-wall", "inflow", "outflow", "far-field")"},
    {"domain.sides.x_lower_velocity", R"(["1 m", "0 m", "0 m"])",
     R"(expected speed such as "0.2 m/s")"},
    {"domain.sides.x_upper", R"("wall")",
     R"(expected one of "no-slip", "slip", "periodic", "moving-wall", "inflow", "outflow", "far-field")"},
    {"domain.sides.x_upper_velocity", R"(["1 m", "0 m", "0 m"])",
     R"(expected speed such as "0.2 m/s")"},
    {"domain.sides.y_lower", R"("wall")",
     R"(expected one of "no-slip", "slip", "periodic", "moving-wall", "inflow", "outflow", "far-field")"},
    {"domain.sides.y_lower_velocity", R"(["1 m", "0 m", "0 m"])",
     R"(expected speed such as "0.2 m/s")"},
    {"domain.sides.y_upper", R"("wall")",
     R"(expected one of "no-slip", "slip", "periodic", "moving-wall", "inflow", "outflow", "far-field")"},
    {"domain.sides.y_upper_velocity", R"(["1 m", "0 m", "0 m"])",
     R"(expected speed such as "0.2 m/s")"},
    {"domain.sides.z_lower", R"("wall")",
     R"(expected one of "no-slip", "slip", "periodic", "moving-wall", "inflow", "outflow", "far-field")"},
    {"domain.sides.z_lower_velocity", R"(["1 m", "0 m", "0 m"])",
     R"(expected speed such as "0.2 m/s")"},
    {"domain.sides.z_upper", R"("wall")",
     R"(expected one of "no-slip", "slip", "periodic", "moving-wall", "inflow", "outflow", "far-field")"},
    {"domain.sides.z_upper_velocity", R"(["1 m", "0 m", "0 m"])",
     R"(expected speed such as "0.2 m/s")"},
    {"solid.name", R"("")",
     "expected a name without comma, brackets, quotation marks, line breaks and control "
     "characters"},
    {"solid.shape", R"("sphere")", R"(expected a table such as { kind = "sphere" })"},
    {"solid.centre", R"("1 m")", R"(expected a list of 3 quantities such as "15 cm")"},
    {"solid.angle", R"("1 Hz")", R"(expected angle such as "4 deg")"},
    {"solid.drive", R"({ kind = "turn" })",
     R"(expected one of "rest", "constant", "sinusoid", "table")"},
    {"cloth.name", R"("a,b")",
     "expected a name without comma, brackets, quotation marks, line breaks and control "
     "characters"},
    {"cloth.fabric", R"("denims")",
     R"(expected one of "energy test cloth", "cotton sheet", "t-shirt jersey", "rib underwear", "terry towel", "polyester shirt", "denim", "trousers", nearest: "denim")"},
    {"cloth.permeability", "\"-1 m/(s Pa)\"", "allowed: >= 0 m/(s Pa)"},
    {"cloth.air_permeability", R"("-1 m/s")", "allowed: >= 0 m/s"},
    {"cloth.areal_mass", R"("0 kg/m^2")", "allowed: > 0 kg/m^2"},
    {"cloth.fibre_density", R"("0 kg/m^3")", "allowed: > 0 kg/m^3"},
    {"cloth.folded", "9", "allowed: 1 to 8"},
    {"cloth.crumpled", "0.7", "allowed: 0 to 0.6"},
    {"cloth.kes.B", "0", "allowed: 0.001 to 10"},
    {"cloth.kes.G", "0", "allowed: 0.01 to 20"},
    {"cloth.kes.LT", "2", "allowed: 0.3 to 1.2"},
    {"cloth.kes.EMT", "0", "allowed: 0.2 to 100"},
    {"cloth.fast.W", "0", "allowed: 10 to 2000"},
    {"cloth.fast.C", "0", "allowed: 1 to 100"},
    {"cloth.fast.E5", "-1", "allowed: 0 to 50"},
    {"cloth.fast.E20", "0", "allowed: 0.05 to 50"},
    {"cloth.fast.EB5", "0", "allowed: 0.2 to 50"},
    {"cloth.count", "100001", "allowed: 0 to 100000"},
    {"cloth.seed", "-1", "allowed: >= 0"},
    {"cloth.size", R"(["0 m", "1 cm"])", "allowed: > 0 m"},
    {"cloth.nodes", "2", "allowed: 3 to 4096"},
    {"cloth.spacing", "9", "allowed: 0.5 to 8"},
    {"cloth.arrangement", R"("heap")",
     R"(expected one of "book", "random", "dropped", "layers", "sheet", "ring")"},
    {"cloth.stretch_stiffness", R"("0 N/m")", "allowed: > 0 N/m"},
    {"cloth.stiffness_beyond", R"("0 N/m")", "allowed: > 0 N/m"},
    {"cloth.knee", "0", "allowed: 0.0001 to 1"},
    {"cloth.load", "[1, 0, 0]",
     R"(expected a formula in Pa between quotes such as "2 * x", or "4 kPa")"},
    {"cloth.shear_stiffness", R"("-1 N/m")", "allowed: >= 0 N/m"},
    {"cloth.bending_stiffness", R"("-1 N m")", "allowed: >= 0 N m"},
    {"cloth.torsion_stiffness", R"("-1 N m")", "allowed: >= 0 N m"},
    {"cloth.poisson", "0.6", "allowed: 0 to 0.5"},
    {"cloth.excess_mass", R"("-1 kg/m^2")", "allowed: >= 0 kg/m^2"},
    {"cloth.loss_time", R"("-1 ms")", "allowed: >= 0 s"},
    {"cloth.friction", "-0.1", "allowed: >= 0"},
    {"cloth.solid_friction", "-0.1", "allowed: >= 0"},
    {"cloth.thickness", R"("0 mm")", "allowed: > 0 m"},
    {"cloth.inner_radius", R"("-1 cm")", "allowed: >= 0 m"},
    {"cloth.bottom", R"("-1 cm")", "allowed: >= 0 m"},
    {"cloth.shift", R"("-1 cm")", "allowed: >= 0 m"},
    {"cloth.clearance", R"("-1 cm")", "allowed: >= 0 m"},
    {"cloth.tilt", R"("-1 deg")", "allowed: >= 0 rad"},
    {"cloth.origin", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"cloth.along_r", R"(["x", 0, 0])", "expected a number without unit such as 0.5"},
    {"cloth.along_s", "[0, 1]", "expected a list of 3 numbers such as 0.5"},
    {"cloth.closed", "1", "expected true or false"},
    {"cloth.pinned", R"("left")", R"(expected one of "r_lower", "r_upper", "s_lower", "s_upper")"},
    {"cloth.clamped", R"("left")", R"(expected one of "r_lower", "r_upper", "s_lower", "s_upper")"},
    {"cloth.centre", R"(["1 m", "1 m", "1 s"])", R"(expected length such as "15 cm")"},
    {"cloth.radius", R"("0 m")", "allowed: > 0 m"},
    {"cloth.curvature", R"("1 m")", R"(expected curvature such as "4 m^-1")"},
    {"cloth.ripple", "1", R"(expected length with its unit such as "15 cm")"},
    {"cloth.ripples", "0", "allowed: > 0"},
    {"probe.name", R"("a,b")",
     "expected a name without comma, brackets, quotation marks, line breaks and control "
     "characters"},
    {"probe.piece", "0", "allowed: 1 to 1000000"},
    {"probe.node", "[0, 4096]", "allowed: -4096 to 4095"},
    {"exact.velocity", R"(["x", "y"])", R"(expected a list of 3 formulas such as "2 * x")"},
    {"exact.relative", R"("yes")", "expected true or false"},
    {"coupling.scheme", R"("implict")",
     R"(expected one of "implicit", "explicit", "broyden", nearest: "implicit")"},
    {"coupling.kernel", R"("hat")", R"(expected one of "cosine", "roma3", "peskin4")"},
    {"coupling.marker_spacing", "0.1", "allowed: 0.25 to 1000"},
    {"contact.scheme", R"("full")", R"(expected one of "layers", "none")"},
    {"contact.range", R"("0 mm")", "allowed: > 0 m"},
    {"contact.pressure", R"("-1 Pa")", "allowed: >= 0 Pa"},
    {"contact.gap", R"("0 mm")", "allowed: > 0 m"},
    {"contact.solid_time", R"("-1 ms")", "allowed: >= 0 s"},
    {"contact.untangle", "1", "expected true or false"},
    {"settle.time", R"("-1 s")", "allowed: >= 0 s"},
    {"settle.gravity", R"(["0 m", "0 m", "1 m"])", R"(expected acceleration such as "9.81 m/s^2")"},
    {"coupling.strain_limit", "0", "allowed: > 0"},
    {"time.end", R"("0 s")", "allowed: > 0 s"},
    {"time.cfl", "0.6", "allowed: > 0 and <= 0.5"},
    {"time.step", R"("0 s")", "allowed: > 0 s"},
    {"time.fixed", "1", "expected true or false"},
    {"solver.divergence", "1", "allowed: 1e-14 to 0.1"},
    {"solver.max_cycles", "0", "allowed: 1 to 1000"},
    {"output.every", R"("0 s")", "allowed: > 0 s"},
    {"output.frames", R"("-1 s")", "allowed: >= 0 s"},
    {"output.stress_time", R"("-1 ms")", "allowed: >= 0 s"},
    {"output.window", R"(["-1 s", "1 s"])", "allowed: >= 0 s"},
    {"checkpoint.every", R"("-1 s")", "allowed: >= 0 s"},
    {"checkpoint.wall_time", R"("-1 s")", "allowed: >= 0 s"},
    {"checkpoint.keep", "0", "allowed: 1 to 1000"},
    {"scale.length", R"("0 m")", "allowed: > 0 m"},
    {"scale.speed", R"("-1 rpm")", "allowed: >= 0 rad/s"},
    {"scale.height", R"("0 m")", "allowed: > 0 m"},
    {"drive constant.speed", R"("2 Hz")", R"(expected angular speed such as "120 rpm")"},
    {"drive sinusoid.peak", R"("0 rpm")", "allowed: > 0 rad/s"},
    {"drive sinusoid.frequency", R"("0 Hz")", "allowed: > 0 Hz"},
    {"drive table.times", R"("0 s")", R"(expected a list of quantities such as "0.5 s")"},
    {"drive table.speeds", "[1]", R"(expected angular speed with its unit such as "120 rpm")"},
    {"drive table.repeat", "0", "expected true or false"},
    {"shape sphere.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape cylinder.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape box.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape capsule.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape half-space.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape revolution.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape plate.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape union.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape intersection.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape difference.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape complement.angle", R"("1 m")", R"(expected angle such as "4 deg")"},
    {"shape sphere.radius", R"("0 m")", "allowed: > 0 m"},
    {"shape sphere.centre", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"shape cylinder.radius", R"("0 m")", "allowed: > 0 m"},
    {"shape cylinder.z_lower", "0", R"(expected length with its unit such as "15 cm")"},
    {"shape cylinder.z_upper", R"("1 s")", R"(expected length such as "15 cm")"},
    {"shape box.lower", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"shape box.upper", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"shape capsule.a", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"shape capsule.b", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"shape capsule.radius", R"("0 m")", "allowed: > 0 m"},
    {"shape half-space.point", "[0, 0, 0]", R"(expected length with its unit such as "15 cm")"},
    {"shape half-space.normal", R"("up")", "expected a list of 3 numbers such as 0.5"},
    {"shape revolution.outline", R"(["1 m", "2 m"])",
     R"(expected a list of 2 quantities such as "15 cm")"},
    {"shape plate.outline", R"(["1 m", "2 m"])",
     R"(expected a list of 2 quantities such as "15 cm")"},
    {"shape plate.half_thickness", R"("0 m")", "allowed: > 0 m"},
    {"shape union.parts", "[]", "expected a list of shapes"},
    {"shape intersection.parts", "[]", "expected a list of shapes"},
    {"shape difference.parts", "[]", "expected a list of shapes"},
    {"shape complement.parts", "[]", "expected a list of shapes"},
};

/// "solid.shape={ kind = "sphere", radius = "0 m" }" for keys of a kind of shape or drive.
std::string setting(const Refusal& refusal) {
  const auto gap = refusal.key.find(' '), dot = refusal.key.rfind('.');
  if (gap == std::string::npos) return refusal.key + "=" + refusal.value;
  return "solid." + refusal.key.substr(0, gap) + "={ kind = \"" +
         refusal.key.substr(gap + 1, dot - gap - 1) + "\", " + refusal.key.substr(dot + 1) + " = " +
         refusal.value + " }";
}

std::string error_with(const std::string& setting) {
  try {
    read_case("cases/wash-3d/case.toml", {setting});
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Keys of the input reference, with the headings of their tables.
std::set<std::string> documented_keys() {
  std::set<std::string> keys;
  std::string heading;
  std::istringstream reference(input_reference());
  for (std::string line; std::getline(reference, line);) {
    if (line.starts_with("## "))
      heading = line.starts_with("## `") ? line.substr(4, line.size() - 5) + "." : "";
    if (line.starts_with("| `")) keys.insert(heading + line.substr(3, line.find('`', 3) - 3));
  }
  return keys;
}

}  // namespace

TEST(Refusals, SayWhereAndWhatIsAllowed) {
  for (const Refusal& refusal : refusals)
    EXPECT_THAT(error_with(setting(refusal)),
                AllOf(StartsWith("--set "), EndsWith(": " + refusal.message)))
        << refusal.key;
}

TEST(Refusals, AreTestedForEveryKey) {
  std::set<std::string> tested;
  for (const Refusal& refusal : refusals) tested.insert(refusal.key);
  EXPECT_EQ(tested, documented_keys());
}
