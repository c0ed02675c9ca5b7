#include "cloth/stress.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "sheets.hpp"

namespace washtub {
namespace {

constexpr double q = 2e-3;
Sheet<3> plate(double nu) {
  return make_plate({6, 5}, {0.01, 0.02}, {8e3, 300, 1e-4, 2e-4, nu, 0, q});
}

double von_mises(double a, double b, double t) {
  return std::sqrt(a * a - a * b + b * b + 3 * t * t);
}

template <int D>
std::vector<NodeStress> stress(const Sheet<D>& sheet, const std::vector<Vec<D>>& X) {
  std::vector<NodeStress> out(X.size());
  Strains strains;
  find_strains<D>(sheet, X, strains);
  find_stress(sheet, X, strains, out);
  return out;
}

TEST(Stress, OfUniformStretchAndShear) {
  const double nu = 0.3, shear = 0.05;
  const auto sheet = plate(nu);
  auto X = testing::flat(sheet);
  for (auto& x : X) x = {1.02 * x[0] + shear * x[1], 1.01 * x[1], 0};
  const double s2 = shear * shear + 1.01 * 1.01;
  const double err = 0.5 * (1 - 1 / (1.02 * 1.02)), ess = 0.5 * (1 - 1 / s2);
  const double esr = 0.5 * shear / std::sqrt(s2);
  const double rr = 8e3 / q * (err + nu * ess), ss = 8e3 / q * (ess + nu * err);
  for (const auto& o : stress(sheet, X)) {
    EXPECT_NEAR(o.component[0], rr, 1e-9 * rr);
    EXPECT_NEAR(o.component[1], ss, 1e-9 * ss);
    EXPECT_NEAR(o.component[2], 300 / q * esr, 1e-9 * rr);
    EXPECT_NEAR(o.membrane, von_mises(rr, ss, 300 / q * esr), 1e-9 * rr);
    EXPECT_NEAR(o.bending, 0, 1e-9 * rr);
    EXPECT_NEAR(o.total, o.membrane, 1e-9 * rr);
  }
}

TEST(Stress, OfSheetBentToCylinder) {
  const double R = 0.25, nu = 0.2;
  const auto sheet = plate(nu);
  auto X = testing::flat(sheet);
  for (auto& x : X) x = {R * std::sin(x[0] / R), x[1], R * std::cos(x[0] / R)};
  const double rr = 6 * 1e-4 / (R * q * q);
  for (const auto& o : stress(sheet, X)) {
    EXPECT_NEAR(o.bending, von_mises(rr, nu * rr, 0), 0.03 * rr);  // ends see a tilted normal
    EXPECT_NEAR(o.component[2], 0, 1e-9 * rr);
  }
}

TEST(Stress, OfTwist) {
  const double twist = 0.1;
  const auto sheet = plate(0);
  auto X = testing::flat(sheet);
  for (auto& x : X) x[2] = twist * (x[0] - 0.025) * (x[1] - 0.04);
  const double sr = 6 * 2e-4 * twist / (q * q);
  for (const auto& o : stress(sheet, X)) EXPECT_NEAR(o.bending, std::sqrt(3) * sr, 1e-4 * sr);
}

TEST(Stress, OfThreadOnCircle) {
  const double R = 0.3;
  const auto sheet = make_thread(20, 0.01, {8e3, 0, 1e-4, 0, 0, 0, q});
  auto X = testing::flat(sheet);
  for (auto& x : X) x = {1.1 * R * std::sin(x[0] / R), 1.1 * R * std::cos(x[0] / R)};
  const double e = 0.5 * (1 - 1 / (1.1 * 1.1));
  for (const auto& o : stress(sheet, X)) {
    EXPECT_NEAR(o.membrane, 8e3 / q * e, 1e-3 * 8e3 / q * e);
    EXPECT_NEAR(o.bending, 6 * 1e-4 / (1.1 * R * q * q), 1.0);
    EXPECT_DOUBLE_EQ(o.total, o.membrane + o.bending);
    EXPECT_DOUBLE_EQ(o.total, o.component[1]);
  }
}

TEST(Stress, AlternatingTensionCountsInFull) {
  const auto sheet = make_thread(12, 0.01, {8e3, 0, 1e-4, 0, 0, 0, q});
  auto X = testing::flat(sheet);
  for (std::size_t i = 1; i < X.size(); i += 2) X[i][0] += 1e-6;
  const double expected = 8e3 / q * 1e-4;
  for (const auto& o : stress(sheet, X)) EXPECT_NEAR(o.membrane, expected, 1e-3 * expected);
}

/// Folded flat on itself the sheet turns by pi over one node spacing, no more.
TEST(Stress, OfAFoldStaysBounded) {
  const auto sheet = make_thread(3, 0.01, {8e3, 0, 1e-4, 0, 0, 0, q});
  const std::vector<Vec<2>> X = {{0, 0}, {0.01, 0}, {0, 1e-9}};
  const double expected = 6 * 1e-4 * (2 / 0.01) / (q * q);
  for (const auto& o : stress(sheet, X)) EXPECT_NEAR(o.bending, expected, 1e-6 * expected);
}

TEST(Stress, NeedsThickness) {
  const auto sheet = make_thread(4, 0.01, {8e3, 0, 1e-4, 0, 0, 0, 0});
  EXPECT_THROW(stress(sheet, testing::flat(sheet)), InputError);
}

}  // namespace
}  // namespace washtub
