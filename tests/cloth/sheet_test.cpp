#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "base/error.hpp"
#include "sheets.hpp"

namespace washtub {
namespace {

template <int D>
double largest(const std::vector<Vec<D>>& F) {
  double out = 0;
  for (const auto& f : F) out = std::max(out, f.norm());
  return out;
}

template <int D>
void expect_force_is_minus_gradient(const Sheet<D>& sheet) {
  auto X = testing::shaken(sheet, 0.03);
  std::vector<Vec<D>> F(X.size());
  sheet.force(X, F);
  const double step = 1e-6, scale = largest(F);
  for (std::size_t i = 0; i < X.size(); ++i) {
    for (int c = 0; c < D; ++c) {
      const double x = X[i][c];
      X[i][c] = x + step;
      const double above = sheet.energy(X);
      X[i][c] = x - step;
      const double below = sheet.energy(X);
      X[i][c] = x;
      EXPECT_NEAR(F[i][c], -(above - below) / (2 * step), 1e-7 * scale) << "node " << i;
    }
  }
}

TEST(Sheet, ForceIsMinusGradientOfEnergy) {
  expect_force_is_minus_gradient(testing::thread());
  expect_force_is_minus_gradient(testing::plate(0));
  expect_force_is_minus_gradient(testing::plate(0.3));
}

TEST(Sheet, ForceIsMinusGradientOfEnergyAcrossSeams) {
  expect_force_is_minus_gradient(testing::ring());
  expect_force_is_minus_gradient(testing::periodic_thread());
  expect_force_is_minus_gradient(testing::tube(0.3));
  expect_force_is_minus_gradient(testing::periodic_plate(0.3));
}

template <int D>
double moment(const Vec<D>& x, const Vec<D>& f) {
  if constexpr (D == 2)
    return x[0] * f[1] - x[1] * f[0];
  else
    return x.cross(f).dot(Vec<3>(0.3, -0.5, 0.8));
}

/// Across a seam with a period there is a couple, which only the net force is free of.
template <int D>
void expect_balanced(const Sheet<D>& sheet, bool moment_too = true) {
  const auto X = testing::shaken(sheet, 0.03);
  std::vector<Vec<D>> F(X.size());
  sheet.force(X, F);
  Vec<D> net = Vec<D>::Zero();
  double turning = 0;
  for (std::size_t i = 0; i < X.size(); ++i) {
    net += F[i];
    turning += moment<D>(X[i], F[i]);
  }
  EXPECT_LT(net.norm(), 1e-12 * largest(F));
  if (moment_too) {
    EXPECT_LT(std::fabs(turning), 1e-12 * largest(F));
  }
}

TEST(Sheet, NetForceAndMomentVanish) {
  expect_balanced(testing::thread());
  expect_balanced(testing::plate(0.3));
  expect_balanced(testing::ring());
  expect_balanced(testing::tube(0.3));
  expect_balanced(testing::periodic_thread(), false);
  expect_balanced(testing::periodic_plate(0.3), false);
}

TEST(Sheet, RigidMotionHasNoForce) {
  const auto sheet = testing::plate(0.3);
  auto X = testing::flat(sheet);
  const Eigen::AngleAxisd turn(1.1, Vec<3>(1, 2, -1).normalized());
  for (auto& x : X) x = turn * x + Vec<3>(3, -2, 1);
  std::vector<Vec<3>> F(X.size());
  sheet.force(X, F);
  EXPECT_LT(largest(F), 1e-12 * sheet.material.stretch);
  EXPECT_LT(sheet.energy(X), 1e-24 * sheet.material.stretch);
}

/// Hessian against differences of the force, by columns.
template <int D>
void expect_hessian(const Sheet<D>& sheet, std::vector<Vec<D>> X, double floor) {
  const Eigen::MatrixXd H = sheet.hessian(X, floor);
  EXPECT_LT((H - H.transpose()).norm(), 1e-14 * H.norm());
  std::vector<Vec<D>> above(X.size()), below(X.size());
  const double step = 1e-6;
  for (std::size_t i = 0; i < X.size(); ++i) {
    for (int c = 0; c < D; ++c) {
      const double x = X[i][c];
      X[i][c] = x + step;
      sheet.force(X, above);
      X[i][c] = x - step;
      sheet.force(X, below);
      X[i][c] = x;
      for (std::size_t k = 0; k < X.size(); ++k)
        for (int d = 0; d < D; ++d)
          EXPECT_NEAR(H(D * k + d, D * i + c), (below[k][d] - above[k][d]) / (2 * step),
                      1e-7 * H.norm());
    }
  }
}

/// Stretched both ways and wrapped around a cylinder: all edges in tension, no shear.
std::vector<Vec<3>> stretched(const Sheet<3>& sheet) {
  auto X = testing::flat(sheet);
  for (auto& x : X) x = {0.5 * std::sin(2.4 * x[0]), 1.1 * x[1], 0.5 * std::cos(2.4 * x[0])};
  return X;
}

TEST(Sheet, HessianIsExactWhereNothingIsCompressed) {
  expect_hessian(testing::plate(0), stretched(testing::plate(0)), 0);
  expect_hessian(testing::plate(0.3), stretched(testing::plate(0.3)), 0);
}

TEST(Sheet, HessianIsExactWithoutFloor) {
  expect_hessian(testing::thread(), testing::shaken(testing::thread(), 0.03), -1e300);
  expect_hessian(testing::plate(0.3), testing::shaken(testing::plate(0.3), 0.03), -1e300);
  expect_hessian(testing::ring(), testing::shaken(testing::ring(), 0.03), -1e300);
  expect_hessian(testing::tube(0.3), testing::shaken(testing::tube(0.3), 0.03), -1e300);
  const auto periodic = testing::periodic_plate(0.3);
  expect_hessian(periodic, testing::shaken(periodic, 0.03), -1e300);
}

TEST(Sheet, HessianWithFloorZeroIsPositiveSemidefinite) {
  const auto sheet = testing::plate(0.3);
  const Eigen::MatrixXd H = sheet.hessian(testing::shaken(sheet, 0.06), 0);
  const auto values = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(H).eigenvalues();
  EXPECT_GT(values.minCoeff(), -1e-12 * values.maxCoeff());
}

TEST(Sheet, AreasSumToTheWhole) {
  const auto sheet = testing::plate(0);
  double area = 0;
  for (const double a : sheet.area) area += a;
  EXPECT_NEAR(area, 4 * 0.1 * 3 * 0.13, 1e-15);
}

TEST(Sheet, EnergyOfUniformStretch) {
  const auto sheet = testing::plate(0.3);
  auto X = testing::flat(sheet);
  for (auto& x : X) x = {1.2 * x[0], 0.9 * x[1], 0};
  const double r = 0.5 * (1.2 * 1.2 - 1), s = 0.5 * (0.9 * 0.9 - 1), area = 4 * 0.1 * 3 * 0.13;
  EXPECT_NEAR(sheet.energy(X), 0.5 * 50 * (r * r + 2 * 0.3 * r * s + s * s) * area, 1e-12);
  EXPECT_NEAR(sheet.largest_strain(X), r, 1e-12);
}

TEST(Sheet, RefusesTooFewNodesAndBadConstants) {
  EXPECT_THROW(make_thread(2, 0.1, {1, 0, 1, 0, 0, 0, 1}), InputError);
  EXPECT_THROW(make_plate({2, 5}, {0.1, 0.1}, {1, 1, 1, 1, 0, 0, 1}), InputError);
  EXPECT_THROW(make_plate({5, 5}, {0.1, 0.1}, {1, 1, 1, 1, 1.5, 0, 1}), InputError);
}

}  // namespace
}  // namespace washtub
