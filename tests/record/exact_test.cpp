#include "record/exact.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "base/error.hpp"

namespace washtub {
namespace {

/// Taylor's and Green's vortices in a periodic square of 2 pi, with a still post if wanted.
Case vortices(bool post = false) {
  Case whole;
  whole.dimension = 2;
  whole.fluid.density = 1;
  whole.fluid.viscosity = 0.1;
  whole.fluid.velocity = {"sin(x) * cos(y)", "-cos(x) * sin(y)", "0"};
  whole.domain.size = {2 * std::numbers::pi, 2 * std::numbers::pi, 0};
  whole.domain.cells = {32, 32, 1};
  for (auto& side : whole.domain.sides) side.kind = SideKind::periodic;
  if (post) whole.solids = {{"post", sphere({3, 3, 0}, 1), Vec<3>::Zero(), at_rest()}};
  whole.time.end = 1;
  whole.exact = ExactCase{
      {"sin(x) * cos(y) * exp(-0.2 * t)", "-cos(x) * sin(y) * exp(-0.2 * t)", "0"}, false};
  return whole;
}

VelocityError error_of(const Simulation<2>& simulation) {
  return ExactSolution<2>(*simulation.definition().exact).compare(simulation);
}

TEST(Exact, InitialVelocityAgreesWithItself) {
  const Simulation<2> simulation(vortices(), Parallel());
  EXPECT_LT(error_of(simulation).largest, 1e-15);
}

TEST(Exact, StartIsMeasured) {
  const Simulation<2> simulation(vortices(), Parallel());
  EXPECT_NEAR(simulation.last().kinetic, std::numbers::pi * std::numbers::pi, 1e-12);
  EXPECT_NEAR(simulation.last().speed, 1, 0.01);
}

TEST(Exact, FollowsTheDecay) {
  Simulation<2> simulation(vortices(), Parallel());
  while (simulation.time() < 0.5) simulation.step(0.5);
  const auto error = error_of(simulation);
  EXPECT_LT(error.largest, 2e-3);  // h^2/12 of the velocity and its decay
  EXPECT_GT(error.largest, 1e-6);
  EXPECT_LT(error.rms, error.largest);
}

TEST(Exact, RelativeErrorIsOverTheExactSpeed) {
  Case whole = vortices();
  whole.fluid.velocity = {"3.3", "0", "0"};
  whole.exact = ExactCase{{"3", "4", "0"}, true};
  const auto error = error_of(Simulation<2>(whole, Parallel()));
  EXPECT_NEAR(error.largest, 0.8, 1e-14);  // of the second component, off by 4 of 5
  EXPECT_NEAR(error.rms, std::sqrt((0.06 * 0.06 + 0.8 * 0.8) / 2), 1e-14);
}

TEST(Exact, LeavesOutSolidsAndSides) {
  Case whole = vortices(true);
  for (auto& side : whole.domain.sides) side.kind = SideKind::no_slip;
  whole.exact->velocity[0] =
      "(x-3)^2 + (y-3)^2 < 1 || x == 0 ? 1e3 : sin(x) * cos(y)";  // wrong there only
  whole.exact->velocity[1] = "(x-3)^2 + (y-3)^2 < 1 || y == 0 ? 1e3 : -cos(x) * sin(y)";
  EXPECT_LT(error_of(Simulation<2>(whole, Parallel())).largest, 1e-14);
}

TEST(Exact, RefusesWhatIsNotFinite) {
  Case whole = vortices();
  whole.fluid.velocity[0] = "sqrt(x - 3)";
  EXPECT_THROW(Simulation<2>(whole, Parallel()), InputError);
}

TEST(Simulation, FirstStepIsBoundByTheInitialVelocity) {
  Simulation<2> simulation(vortices(), Parallel());
  const double h = 2 * std::numbers::pi / 32;
  const auto& step = simulation.step(1);
  EXPECT_LT(step.dt, 0.3 * h);  // the CFL number of the largest speed, 1, along both axes
  EXPECT_LE(step.courant, 0.3);
}

}  // namespace
}  // namespace washtub
