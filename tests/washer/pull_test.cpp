#include <fmt/format.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "washer/simulation.hpp"

using namespace washtub;

namespace {

/// A heavy cloth in a gas so thin that it hardly matters.
Case pulled(const std::string& load) {
  return read_case_text(fmt::format(R"(
[fluid]
density = "0.001 kg/m^3"
viscosity = "1e-8 Pa s"
[domain]
size = ["64 cm", "64 cm", "64 cm"]
cells = 16
[[cloth]]
arrangement = "sheet"
origin = ["24 cm", "24 cm", "32 cm"]
along_r = [1, 0, 0]
along_s = [0, 1, 0]
size = ["16 cm", "16 cm"]
nodes = 5
excess_mass = "2 kg/m^2"
stretch_stiffness = "1e4 N/m"
shear_stiffness = "1e3 N/m"
bending_stiffness = "1e-2 N m"
torsion_stiffness = "1e-2 N m"
thickness = "1 mm"
load = {}
[contact]
scheme = "none"
[time]
end = "0.2 s"
step = "2 ms"
fixed = true
[output]
every = "20 ms"
)",
                                    load),
                        "pulled");
}

Vec<3> middle(const Simulation<3>& simulation) {
  Vec<3> sum = Vec<3>::Zero();
  for (const auto& x : simulation.cloth().position) sum += x;
  return sum / simulation.cloth().nodes();
}

}  // namespace

/// 3 Pa on 2 kg/m^2 are 1.5 m/s^2, which end when t passes 0.1 s; the work becomes motion.
TEST(Pull, AcceleratesByFormulaAndItsWorkIsFoundAgain) {
  Simulation<3> simulation(pulled(R"(["t < 0.1 ? 3 : 0", "0", "0"])"), Parallel());
  const Vec<3> start = middle(simulation);
  while (simulation.time() < 0.2 - 1e-9) simulation.step(0.2);
  const Vec<3> way = middle(simulation) - start;
  EXPECT_NEAR(way[0], 0.5 * 1.5 * 0.01 + 0.15 * 0.1, 0.02 * way[0]);
  EXPECT_NEAR(way[1], 0, 1e-9);
  const double area = 0.16 * 0.16;
  EXPECT_NEAR(simulation.work_on_cloth(), 3 * area * 0.5 * 1.5 * 0.01, 0.03 * 3 * area * 0.0075);
}

/// The formulas see where the cloth is: the halves are drawn apart.
TEST(Pull, DependsOnThePlace) {
  Simulation<3> simulation(pulled(R"(["x < 0.31 ? -100 : x > 0.33 ? 100 : 0", "0", "0"])"),
                           Parallel());
  const double before = simulation.cloth().position[4][0] - simulation.cloth().position[0][0];
  while (simulation.time() < 0.1) simulation.step(0.2);
  const auto& x = simulation.cloth().position;
  EXPECT_GT(x[4][0] - x[0][0], before + 2e-5);
  EXPECT_NEAR(0.5 * (x[4][0] + x[0][0]), 0.32, 1e-3);
}

/// At the start it is a mistake in the file, later a run that goes wrong.
TEST(Pull, RefusesALoadThatIsNotFinite) {
  EXPECT_THROW(Simulation<3>(pulled(R"x(["1 / t", "0", "0"])x"), Parallel()), InputError);
  Simulation<3> simulation(pulled(R"x(["t < 0.003 ? 0 : 1 / (t - t)", "0", "0"])x"), Parallel());
  simulation.step(0.2);
  try {
    simulation.step(0.2);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("the load of \"cloth\", \"t < 0.003"),
              std::string::npos)
        << error.what();
  }
}

/// The first step is no longer than what the load lets it be.
TEST(Pull, BoundsTheFirstStep) {
  Case whole = pulled(R"(["5000", "0", "0"])");
  whole.time.fixed = false;
  whole.time.step = 0;
  Simulation<3> simulation(whole, Parallel());
  EXPECT_LT(simulation.step(0.2).dt, 0.01);
}
