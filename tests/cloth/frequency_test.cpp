#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numbers>

#include "base/error.hpp"
#include "cloth/modes.hpp"
#include "sheets.hpp"

namespace washtub {
namespace {

constexpr double side = 0.7, density = 2.5, stiffness = 0.04;  // [m], [kg/m^2], [N m]

/// lambda^2 = omega side^2 sqrt(density/stiffness) of the lowest modes, with `held` nodes fixed.
template <int D>
std::vector<double> frequencies(const Sheet<D>& sheet, const std::vector<int>& held) {
  auto out = natural_frequencies(sheet, held, density, 3);
  const double unit = std::sqrt(stiffness / density) / (side * side);
  for (double& f : out) f *= 2 * std::numbers::pi / unit;
  return out;
}

Material isotropic(double nu) {
  return {100, 100 * (1 - nu), stiffness, stiffness * (1 - nu), nu, 0, 1e-3};
}

/// A clamp holds two rows of nodes; it acts midway between them.
std::vector<double> cantilever_plate(int n) {
  const auto sheet = make_plate({n, n}, {side / (n - 1.5), side / (n - 1)}, isotropic(0.3));
  std::vector<int> held;
  for (int j = 0; j < n; ++j) held.insert(held.end(), {sheet.node(0, j), sheet.node(1, j)});
  return frequencies(sheet, held);
}

std::vector<double> free_plate(int n) {
  const auto sheet = make_plate({n, n}, {side / (n - 1), side / (n - 1)}, isotropic(0.3));
  return frequencies(sheet, {});
}

/// M. V. Barton, J. Appl. Mech. 18 (1951) 129.
constexpr std::array<double, 3> cantilever_exact = {3.492, 8.525, 21.43};
/// NAFEMS R0015, test FV12. Barton's 13.49, 19.79, 24.43 are Ritz bounds up to 1 % above.
constexpr std::array<double, 3> free_exact = {13.47, 19.60, 24.27};

TEST(Frequency, CantileverPlateOf17x17Nodes) {
  const auto got = cantilever_plate(17);
  for (int m = 0; m < 3; ++m)
    EXPECT_NEAR(got[m], cantilever_exact[m], 0.02 * cantilever_exact[m]) << "mode " << m;
}

TEST(Frequency, FreePlateOf17x17Nodes) {
  const auto got = free_plate(17);
  for (int m = 0; m < 3; ++m)
    EXPECT_NEAR(got[m], free_exact[m], 0.02 * free_exact[m]) << "mode " << m;
}

TEST(Frequency, FreePlateConvergesAtSecondOrder) {
  const auto coarse = free_plate(9), fine = free_plate(17);  // spacing halved
  for (int m = 0; m < 3; ++m) {
    const double ratio = (coarse[m] - free_exact[m]) / (fine[m] - free_exact[m]);
    EXPECT_GT(ratio, 3.4);
    EXPECT_NEAR((4 * fine[m] - coarse[m]) / 3, free_exact[m], 0.004 * free_exact[m]);
  }
}

TEST(Frequency, CantileverThread) {
  const int n = 31;
  const auto sheet = make_thread(n, side / (n - 1.5), {100, 0, stiffness, 0, 0, 0, 1e-3});
  const auto got = frequencies(sheet, {0, 1});
  EXPECT_NEAR(got[0], 3.516, 0.01 * 3.516);
  EXPECT_NEAR(got[1], 22.03, 0.01 * 22.03);
}

TEST(Frequency, FreeThreadHasNoRigidModesAndNoMoreThanItHas) {
  const auto sheet = make_thread(6, 0.1, {100, 0, stiffness, 0, 0, 0, 1e-3});
  EXPECT_EQ(natural_frequencies(sheet, {}, density, 99).size(), 4U);
  EXPECT_EQ(natural_frequencies(sheet, {2}, density, 99).size(), 4U);  // turns about the pin
  EXPECT_EQ(natural_frequencies(sheet, {0, 1}, density, 2).size(), 2U);
}

/// (2 sin(k h/2)/h)^2 of wave number `wave` along n nodes at spacing h.
double difference(int wave, int n, double h) {
  return (2 - 2 * std::cos(2 * std::numbers::pi * wave / n)) / (h * h);
}

TEST(Frequency, WavesOfPeriodicThread) {
  const auto sheet = testing::periodic_thread();
  const int n = sheet.nodes();
  const auto got = natural_frequencies(sheet, {}, density, 99);
  ASSERT_EQ(got.size(), static_cast<std::size_t>(n - 1));
  for (int m = 0; m < n - 1; ++m) {
    const double omega =
        std::sqrt(sheet.material.bending / density) * difference(m / 2 + 1, n, 0.1);
    EXPECT_NEAR(2 * std::numbers::pi * got[m], omega, 1e-9 * omega) << "mode " << m;
  }
}

TEST(Frequency, WavesOfPlateClosedBothWays) {
  const auto sheet = testing::periodic_plate(0.3);
  const Material& m = sheet.material;
  const auto [nr, ns] = sheet.extent;
  std::vector<double> exact;
  for (int p = 0; p < nr; ++p)
    for (int q = 0; q < ns; ++q) {
      const double r = difference(p, nr, sheet.spacing[0]), s = difference(q, ns, sheet.spacing[1]);
      const double square = m.bending * (r * r + 2 * 0.3 * r * s + s * s) + 2 * m.torsion * r * s;
      if (p + q > 0) exact.push_back(std::sqrt(square / density) / (2 * std::numbers::pi));
    }
  std::sort(exact.begin(), exact.end());
  const auto got = natural_frequencies(sheet, {}, density, 99);
  ASSERT_EQ(got.size(), exact.size());
  for (std::size_t i = 0; i < got.size(); ++i) EXPECT_NEAR(got[i], exact[i], 1e-9 * exact[i]);
}

TEST(Frequency, NeedsAMassAndAFlatSheet) {
  EXPECT_THROW(natural_frequencies(testing::thread(), {}, 0, 5), InputError);
  EXPECT_THROW(natural_frequencies(testing::ring(), {}, density, 5), InputError);
}

}  // namespace
}  // namespace washtub
