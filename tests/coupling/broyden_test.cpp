#include "coupling/broyden.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "base/error.hpp"
#include "coupling/pool.hpp"

using namespace washtub;
using namespace washtub::testing;

namespace {

/// The stretched thread in a shear flow after 0.1 s.
std::vector<Vec<2>> after_shear(Scheme scheme, double dt, double stiffness) {
  Pool<2> pool(square(), 1, stretched_thread(1.02, 0, stiffness), scheme);
  pool.water.start_from([](int d, const Vec<2>& x) {
    return d == 0 ? 0.5 * std::sin(2 * std::numbers::pi * x[1]) : 0.0;
  });
  for (int i = 0; i < std::lround(0.1 / dt); ++i) pool.step(dt, 1e-5);
  return pool.cloth.position;
}

double apart(const std::vector<Vec<2>>& a, const std::vector<Vec<2>>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

}  // namespace

TEST(Broyden, SolvesALinearEquationInTwiceItsSizeSteps) {
  const auto residual = [](const std::vector<Vec<2>>& X) {
    const Vec<2> a = X[0], b = X[1];
    return std::vector<Vec<2>>{{3 * a[0] - b[1] - 1, 2 * a[1] + b[0]},
                               {a[1] + 4 * b[0] - 2, 1.5 * b[1] + a[0] - 0.3}};
  };
  Broyden<2> broyden;
  std::vector<Vec<2>> X(2, Vec<2>::Zero());
  for (int i = 0; i < 8; ++i) {
    const auto& step = broyden.step(residual(X));
    for (int n = 0; n < 2; ++n) X[n] += step[n];
  }
  EXPECT_EQ(broyden.count(), 8);
  for (const auto& r : residual(X)) EXPECT_LT(r.norm(), 1e-9);
}

TEST(Broyden, GoesWhereTheImplicitSchemeGoesAsStepsShrink) {
  const auto reference = after_shear(Scheme::explicit_euler, 1.25e-4, 200);
  for (const Scheme scheme : {Scheme::broyden, Scheme::implicit}) {
    const double coarse = apart(after_shear(scheme, 4e-3, 200), reference);
    const double fine = apart(after_shear(scheme, 1e-3, 200), reference);
    EXPECT_LT(fine, 0.4 * coarse);
    EXPECT_LT(fine, 2e-4);  // it has gone 4 cm
  }
}

TEST(Broyden, CarriesStiffClothAtAStepWhereForwardEulerFails) {
  const auto energy_left = [](Scheme scheme) {
    Pool<2> pool(square(), 1, stretched_thread(1, 0, 4e5), scheme);
    const double start = pool.elastic();  // at a strain of 0.02
    for (int i = 0; i < 60 && pool.elastic() < 1e3 * start; ++i) pool.step(2.5e-3, 1e-5);
    return pool.elastic() / start;
  };
  EXPECT_LT(energy_left(Scheme::broyden), 1e-4);
  EXPECT_FALSE(energy_left(Scheme::explicit_euler) < 1);
}

TEST(Broyden, NamesTheWayOutWhereItDoesNotConverge) {
  Pool<2> pool(square(), 1, stretched_thread(1.05, 0, 1e8), Scheme::broyden);
  try {
    for (int i = 0; i < 10; ++i) pool.step(4e-3, 1e-5);
    FAIL();
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("try a smaller time.step"), std::string::npos);
  }
}
