#include <gtest/gtest.h>

#include "cloth/stress.hpp"
#include "sheets.hpp"

namespace washtub {
namespace {

/// 50 N/m up to a strain of 0.02, 400 N/m beyond.
Material stiffening() {
  Material m{50, 20, 0.3, 0.2, 0, 0, 1e-3};
  m.stretch_beyond = 400;
  m.knee = 0.02;
  return m;
}

/// Green's strain of a thread drawn to `part` of its length.
double strain(double part) { return 0.5 * (part * part - 1); }

/// W per length is 25 E^2, and beyond the knee 175 (E - 0.02)^2 more; squeezed cloth is soft.
TEST(Stiffening, EnergyHasTwoStraightLinesOfTension) {
  const auto sheet = make_thread(9, 0.1, stiffening());
  for (const double part : {0.9, 1.01, 1.1}) {
    auto X = testing::flat(sheet);
    for (auto& x : X) x *= part;
    const double E = strain(part), more = std::max(0.0, E - 0.02);
    EXPECT_NEAR(sheet.energy(X), 0.8 * (25 * E * E + 175 * more * more), 1e-12) << part;
  }
}

TEST(Stiffening, ForceIsMinusGradientOfEnergyAndHessianThatOfForce) {
  const auto sheet = make_plate({5, 4}, {0.1, 0.13}, stiffening());
  auto X = testing::shaken(sheet, 0.03);
  const Eigen::MatrixXd H = sheet.hessian(X, -1e300);
  std::vector<Vec<3>> F(X.size()), above(X.size()), below(X.size());
  sheet.force(X, F);
  const double step = 1e-6;
  for (std::size_t i = 0; i < X.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double x = X[i][c];
      X[i][c] = x + step;
      const double upper = sheet.energy(X);
      sheet.force(X, above);
      X[i][c] = x - step;
      const double lower = sheet.energy(X);
      sheet.force(X, below);
      X[i][c] = x;
      EXPECT_NEAR(F[i][c], -(upper - lower) / (2 * step), 1e-7 * 400);
      for (std::size_t k = 0; k < X.size(); ++k)
        for (int d = 0; d < 3; ++d)
          EXPECT_NEAR(H(3 * k + d, 3 * i + c), (below[k][d] - above[k][d]) / (2 * step),
                      1e-7 * H.norm());
    }
}

/// The stress is the tension over the thickness, with the strain of Eq. (12).
TEST(Stiffening, StressFollowsTheTension) {
  const auto sheet = make_thread(9, 0.1, stiffening());
  auto X = testing::flat(sheet);
  for (auto& x : X) x *= 1.1;
  Strains strains;
  find_strains<2>(sheet, X, strains);
  std::vector<NodeStress> stress(X.size());
  find_stress(sheet, X, strains, stress);
  const double e = 0.5 * (1 - 1 / (1.1 * 1.1));
  EXPECT_NEAR(stress[4].membrane, (50 * e + 350 * (strain(1.1) - 0.02) / (1.1 * 1.1)) / 1e-3, 1e-8);
}

/// Poisson's coupling stays that of the soft cloth, as in the energy: per area, stretched alike
/// both ways, the stress is dW/dE over 2 and over the square of the stretch.
TEST(Stiffening, StressOfAPlateIsThatOfItsEnergy) {
  Material m = stiffening();
  m.poisson = 0.3;
  const auto sheet = make_plate({5, 5}, {0.1, 0.1}, m);
  const auto energy = [&](double part) {
    auto X = testing::flat(sheet);
    for (auto& x : X) x *= part;
    return sheet.energy(X) / 0.16;
  };
  const double part = 1.05, step = 1e-5;
  const double slope =
      (energy(part + step) - energy(part - step)) / (strain(part + step) - strain(part - step));
  auto X = testing::flat(sheet);
  for (auto& x : X) x *= part;
  Strains strains;
  find_strains<3>(sheet, X, strains);
  std::vector<NodeStress> stress(X.size());
  find_stress(sheet, X, strains, stress);
  EXPECT_NEAR(stress[12].membrane, slope / 2 / (part * part) / 1e-3, 1e-4 * stress[12].membrane);
}

}  // namespace
}  // namespace washtub
