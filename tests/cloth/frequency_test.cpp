#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>

#include "sheets.hpp"

namespace washtub {
namespace {

constexpr double side = 0.7, density = 2.5, stiffness = 0.04;  // [m], [kg/m^2], [N m]

/// lambda^2 = omega side^2 sqrt(density/stiffness) of the lowest modes normal to the flat sheet,
/// with `held` nodes fixed; masses lumped at the nodes.
template <int D>
std::vector<double> frequencies(const Sheet<D>& sheet, const std::vector<int>& held) {
  std::vector<int> free;
  for (int x = 0; x < sheet.nodes(); ++x)
    if (std::find(held.begin(), held.end(), x) == held.end()) free.push_back(x);
  const Eigen::SparseMatrix<double> H = sheet.hessian(testing::flat(sheet), 0);
  const int n = static_cast<int>(free.size()), normal = D == 2 ? 1 : 2;
  Eigen::MatrixXd A(n, n);
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k)
      A(i, k) = H.coeff(D * free[i] + normal, D * free[k] + normal) /
                (density * std::sqrt(sheet.area[free[i]] * sheet.area[free[k]]));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(A, Eigen::EigenvaluesOnly);
  std::vector<double> out;
  for (const double value : modes.eigenvalues())
    out.push_back(std::sqrt(std::max(value, 0.0) * density / stiffness) * side * side);
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
  auto all = frequencies(sheet, {});
  all.erase(all.begin(), all.begin() + 3);  // rigid motions
  return all;
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

}  // namespace
}  // namespace washtub
