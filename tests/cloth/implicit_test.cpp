#include "cloth/implicit.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <limits>
#include <numeric>

#include "sheets.hpp"

namespace washtub {
namespace {

/// Targets and stiffnesses of several pieces, each at random.
template <int D>
struct Group {
  std::vector<int> pieces;
  std::vector<Vec<D>> stiffness, target, Y, F;
  std::vector<Mat<D>> K;

  Group(const Sheet<D>& sheet, int count, double shake, double k) : pieces(count) {
    std::iota(pieces.begin(), pieces.end(), 0);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> factor(0.5, 2);
    for (int p = 0; p < count; ++p) {
      const auto X = testing::shaken(sheet, shake, static_cast<unsigned>(p));
      target.insert(target.end(), X.begin(), X.end());
      for (int x = 0; x < sheet.nodes(); ++x)
        for (stiffness.emplace_back(); auto& value : stiffness.back()) value = k * factor(random);
    }
    Y.assign(target.size(), Vec<D>::Constant(-1));
    F.assign(target.size(), Vec<D>::Constant(-1));
  }
  auto solve(ClothSolver<D>& solver, const std::vector<int>& which) {
    K.clear();
    for (const auto& k : stiffness) K.push_back(k.asDiagonal());
    return solver.solve(which, {K, target}, Y, F);
  }
  auto solve(ClothSolver<D>& solver) { return solve(solver, pieces); }
};

/// Largest component of k (Y - Z) - F(Y), in units of k times a node spacing.
template <int D>
double residual(const Sheet<D>& sheet, const Group<D>& group, int piece) {
  const int n = sheet.nodes();
  const std::span Y(group.Y.data() + piece * n, static_cast<std::size_t>(n));
  std::vector<Vec<D>> F(n);
  sheet.force(Y, F);
  double out = 0;
  for (int x = 0; x < n; ++x) {
    const Vec<D> pull =
        group.stiffness[piece * n + x].cwiseProduct(Y[x] - group.target[piece * n + x]);
    out = std::max(
        out, (pull - F[x]).cwiseQuotient(group.stiffness[piece * n + x]).cwiseAbs().maxCoeff());
  }
  return out / sheet.smallest_spacing();
}

template <int D>
void expect_solved(const Sheet<D>& sheet, double shake, double k, double tolerance) {
  Group<D> group(sheet, 11, shake, k);
  ClothSolver<D> solver(sheet);
  const auto report = group.solve(solver);
  EXPECT_EQ(report.failed, -1);
  EXPECT_LE(report.iterations, 30);
  double strain = 0;
  for (int p = 0; p < 11; ++p) {
    EXPECT_LT(residual(sheet, group, p), tolerance) << "piece " << p;
    const std::span Y(group.Y.data() + p * sheet.nodes(), static_cast<std::size_t>(sheet.nodes()));
    strain = std::max(strain, sheet.largest_strain(Y));
  }
  EXPECT_DOUBLE_EQ(report.largest_strain, strain);
}

TEST(ClothSolver, SatisfiesItsEquation) {
  expect_solved(testing::thread(), 0.01, 100, 1e-6);
  expect_solved(testing::plate(0), 0.01, 10, 1e-5);
  expect_solved(testing::plate(0.3), 0.03, 10, 1e-5);
}

TEST(ClothSolver, SatisfiesItsEquationOnClosedSheets) {
  expect_solved(testing::ring(), 0.01, 100, 1e-6);
  expect_solved(testing::periodic_thread(), 0.01, 100, 1e-6);
  expect_solved(testing::tube(0.3), 0.02, 10, 1e-5);
  expect_solved(testing::periodic_plate(0.3), 0.02, 10, 1e-5);
}

TEST(ClothSolver, SolvesThePapersStiffness) {
  const double ds = 0.15 / 6;
  const auto sheet = make_plate({7, 7}, {ds, ds}, {8e5, 3e2, 1e-5, 1e-5, 0, 0, 2.4e-4});
  Group<3> group(sheet, 8, 0.01 * ds, 2800);
  ClothSolver<3> solver(sheet);
  const auto report = group.solve(solver);
  EXPECT_EQ(report.failed, -1);
  EXPECT_LE(report.iterations, 10);
  EXPECT_LT(report.largest_strain, 1e-3);
}

TEST(ClothSolver, PieceDoesNotDependOnItsCompany) {
  const auto sheet = testing::plate(0.3);
  Group<3> together(sheet, 11, 0.03, 10);
  Group<3> alone = together;
  ClothSolver<3> solver(sheet);
  together.solve(solver);
  for (const int p : {0, 5, 10}) alone.solve(solver, {p});
  const int n = sheet.nodes();
  for (const int p : {0, 5, 10})
    for (int x = p * n; x < (p + 1) * n; ++x)
      EXPECT_LT((together.Y[x] - alone.Y[x]).norm(), 1e-6 * sheet.smallest_spacing());
  EXPECT_EQ(alone.Y[n], Vec<3>::Constant(-1)) << "a piece that was not listed was written";
}

/// Newton's method with a dense exact Hessian.
TEST(ClothSolver, AgreesWithDenseReference) {
  const auto sheet = testing::plate(0.3);
  Group<3> group(sheet, 1, 0.02, 30);
  ClothSolver<3> solver(sheet, {}, 1e-11);
  group.solve(solver);
  const auto flatten = [&](const std::vector<Vec<3>>& v) {
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>(v[0].data(), 3 * sheet.nodes()));
  };
  const Eigen::VectorXd k = flatten(group.stiffness), Z = flatten(group.target);
  std::vector<Vec<3>> X = group.target, F(X.size());
  for (int iteration = 0; iteration < 20; ++iteration) {
    sheet.force(X, F);
    Eigen::MatrixXd A = sheet.hessian(X, iteration < 5 ? 0 : -1e300);
    A.diagonal() += k;
    const Eigen::VectorXd gradient = k.cwiseProduct(flatten(X) - Z) - flatten(F);
    Eigen::Map<Eigen::VectorXd>(X[0].data(), 3 * sheet.nodes()) -= A.ldlt().solve(gradient);
  }
  for (std::size_t x = 0; x < X.size(); ++x) EXPECT_LT((X[x] - group.Y[x]).norm(), 1e-10);
}

TEST(ClothSolver, PinnedNodesStayAtTheirTarget) {
  const auto sheet = testing::plate(0);
  const std::vector<int> pinned = {0, 1, 2, 3, 4};
  Group<3> group(sheet, 3, 0.02, 10);
  ClothSolver<3> solver(sheet, pinned);
  const auto report = group.solve(solver);
  EXPECT_EQ(report.failed, -1);
  for (int p = 0; p < 3; ++p) {
    const std::span Y(group.Y.data() + p * sheet.nodes(), static_cast<std::size_t>(sheet.nodes()));
    std::vector<Vec<3>> F(sheet.nodes());
    sheet.force(Y, F);
    for (int x = 0; x < sheet.nodes(); ++x) {
      const Vec<3> Z = group.target[p * sheet.nodes() + x],
                   k = group.stiffness[p * sheet.nodes() + x];
      if (x < 5)
        EXPECT_EQ(Y[x], Z);
      else
        EXPECT_LT((k.cwiseProduct(Y[x] - Z) - F[x]).norm(), 1e-5);
    }
  }
}

/// Held against any direction, as by a surface along its normal alone.
TEST(ClothSolver, TakesStiffnessInAnyDirection) {
  const auto sheet = testing::plate(0.3);
  Group<3> group(sheet, 3, 0.02, 30);
  ClothSolver<3> solver(sheet);
  group.solve(solver);
  const int node = sheet.nodes() + 7;
  const Vec<3> n = Vec<3>(1, -2, 2) / 3;
  group.K[node] += 1e4 * 30 * n * n.transpose();
  const auto report = solver.solve(group.pieces, {group.K, group.target}, group.Y, group.F);
  EXPECT_EQ(report.failed, -1);
  std::vector<Vec<3>> F(sheet.nodes());
  for (int p = 0; p < 3; ++p) {
    sheet.force(std::span(group.Y).subspan(p * sheet.nodes(), sheet.nodes()), F);
    for (int x = 0; x < sheet.nodes(); ++x) {
      const int i = p * sheet.nodes() + x;
      EXPECT_LT((group.F[i] - F[x]).norm(), 1e-12 * (1 + F[x].norm()));
      EXPECT_LT((group.K[i] * (group.Y[i] - group.target[i]) - F[x]).norm(), 1e-3);
    }
  }
  EXPECT_LT(std::abs(n.dot(group.Y[node] - group.target[node])), 1e-4);
}

/// A plate that turns and bends as a whole between two steps has no loss; one that stretches evenly
/// has the stress K (E + tau (E - E^n)/dt).
TEST(ClothSolver, LosesByTheRateOfStrainAlone) {
  constexpr double dt = 1e-3, tau = 3e-3, hold = 1e9;
  auto sheet = testing::plate(0.3);
  const auto flat = testing::shaken(sheet, 0, 0);
  const auto solve = [&](double loss, double stretch, double angle, double before = 1) {
    sheet.material.loss_time = loss;
    ClothSolver<3> solver(sheet);
    std::vector<Vec<3>> X, Z, Y(flat.size()), F(flat.size());
    for (const auto& x : flat) {
      X.push_back(before * x);
      Z.emplace_back(stretch * (std::cos(angle) * x[0] - std::sin(angle) * x[1]),
                     stretch * (std::sin(angle) * x[0] + std::cos(angle) * x[1]), stretch * x[2]);
    }
    const std::vector<Mat<3>> K(flat.size(), hold * Mat<3>::Identity());
    solver.solve(std::vector{0}, {K, Z, X, dt}, Y, F);
    return F;
  };
  const double scale = sheet.material.stretch * sheet.spacing[0];
  for (const auto& f : solve(tau, 1, 0.5)) EXPECT_LT(f.norm(), 1e-9 * scale);
  const auto elastic = solve(0, 1.001, 0.5), lossy = solve(tau, 1.001, 0.5);
  for (std::size_t i = 0; i < flat.size(); ++i)
    EXPECT_LT((lossy[i] - (1 + tau / dt) * elastic[i]).norm(), 1e-4 * elastic[0].norm());
  const auto kept = solve(tau, 1.001, 0.5, 1.001);  // a strain that stays has no loss either
  for (std::size_t i = 0; i < flat.size(); ++i)
    EXPECT_LT((kept[i] - elastic[i]).norm(), 1e-4 * elastic[0].norm());
  EXPECT_GT(elastic[0].norm(), 1e-5 * scale);
}

TEST(ClothSolver, RestIsFoundInOneStep) {
  const auto sheet = testing::plate(0.3);
  Group<3> group(sheet, 2, 0, 10);
  ClothSolver<3> solver(sheet);
  const auto report = group.solve(solver);
  EXPECT_EQ(report.failed, -1);
  EXPECT_EQ(report.iterations, 1);
  EXPECT_LT((group.Y[7] - group.target[7]).norm(), 1e-14);
}

TEST(ClothSolver, NamesThePieceThatFailedAndSolvesTheOthers) {
  const auto sheet = testing::plate(0);
  Group<3> group(sheet, 4, 0.02, 10);
  group.target[2 * sheet.nodes() + 3][1] = std::numeric_limits<double>::quiet_NaN();
  ClothSolver<3> solver(sheet);
  const auto report = group.solve(solver);
  EXPECT_EQ(report.failed, 2);
  for (const int p : {0, 1, 3}) EXPECT_LT(residual(sheet, group, p), 1e-5);
}

TEST(BlockCholesky, SolvesEachLane) {
  const auto sheet = testing::plate(0.3);
  const auto pairs = couplings(sheet);
  BlockCholesky<3> cholesky(sheet.nodes(), pairs, {});
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  std::vector<Eigen::MatrixXd> A(lanes, Eigen::MatrixXd::Zero(60, 60));
  for (const auto& [x, y] : pairs) {
    const Place p = cholesky.place(x, y);
    for (int i = 0; i < 9 * lanes; ++i) {
      const int l = i % lanes, r = i / lanes / 3, c = i / lanes % 3;
      const double value = x == y ? (r == c ? 60.0 : 0.0) : normal(random);
      A[l](3 * x + r, 3 * y + c) = A[l](3 * y + c, 3 * x + r) = value;
      const int at = p.transposed ? c * 3 + r : r * 3 + c;
      cholesky.data()[(p.index * 9 + at) * lanes + l] = value;
    }
  }
  LaneVector<double> x(60 * lanes, 1.0);
  cholesky.factorise();
  cholesky.solve(x.data());
  for (int l = 0; l < lanes; ++l) {
    const Eigen::VectorXd exact = A[l].llt().solve(Eigen::VectorXd::Ones(60));
    for (int n = 0; n < 20; ++n)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(x[(cholesky.position(n) * 3 + c) * lanes + l], exact[3 * n + c], 1e-12);
  }
}

}  // namespace
}  // namespace washtub
