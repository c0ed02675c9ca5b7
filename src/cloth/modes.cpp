#include "cloth/modes.hpp"

#include <Eigen/Eigenvalues>
#include <limits>
#include <numbers>

#include "base/error.hpp"

namespace washtub {
namespace {

template <int D>
void check(const Sheet<D>& sheet, double areal_mass) {
  if (!(areal_mass > 0))
    throw InputError("vibrations in vacuo need a mass of the sheet > 0; set its excess mass");
  for (int d = 0; d < 2; ++d)
    if (sheet.closed[d] && sheet.period[d].isZero(0))
      throw InputError("modes are found for flat sheets only, and a ring or tube is not flat");
}

/// Number of each node among those that are free, -1 if pinned; the second is how many are free.
std::pair<std::vector<int>, int> number_free(int nodes, const std::vector<int>& pinned) {
  std::vector<int> number(static_cast<std::size_t>(nodes), 0);
  for (const int x : pinned) number[x] = -1;
  int free = 0;
  for (int& n : number)
    if (n == 0) n = free++;
  return {number, free};
}

template <int D, bool seam>
void add_bending(const std::vector<Bend<D, seam>>& bends, const std::vector<int>& number,
                 Eigen::MatrixXd& K) {
  for (const auto& e : bends)
    for (int m = 0; m < e.count; ++m)
      for (int n = 0; n < e.count; ++n) {
        const int row = number[e.node[m]], column = number[e.node[n]];
        if (row >= 0 && column >= 0) K(row, column) += e.stiffness * e.weight[m] * e.weight[n];
      }
}

/// M^-1/2 K M^-1/2 of the free nodes [1/s^2]. Flat and at rest all strains vanish, and with them
/// their part of the Hessian normal to the sheet.
template <int D>
Eigen::MatrixXd dynamic_matrix(const Sheet<D>& sheet, const std::vector<int>& pinned,
                               double areal_mass) {
  const auto [number, free] = number_free(sheet.nodes(), pinned);
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(free, free);
  add_bending(sheet.inner.bends, number, K);
  add_bending(sheet.seam.bends, number, K);
  Eigen::VectorXd scale(free);
  for (int x = 0; x < sheet.nodes(); ++x)
    if (number[x] >= 0) scale[number[x]] = 1 / std::sqrt(areal_mass * sheet.area[x]);
  return scale.asDiagonal() * K * scale.asDiagonal();
}

}  // namespace

template <int D>
std::vector<double> natural_frequencies(const Sheet<D>& sheet, const std::vector<int>& pinned,
                                        double areal_mass, int count) {
  check(sheet, areal_mass);
  const Eigen::MatrixXd A = dynamic_matrix(sheet, pinned, areal_mass);
  if (A.rows() == 0) return {};
  const Eigen::VectorXd squares =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(A, Eigen::EigenvaluesOnly).eigenvalues();
  const double round_off = 8 * static_cast<double>(A.rows()) *
                           std::numeric_limits<double>::epsilon() * squares.maxCoeff();
  std::vector<double> out;
  for (const double square : squares)
    if (square > round_off && static_cast<int>(out.size()) < count)
      out.push_back(std::sqrt(square) / (2 * std::numbers::pi));
  return out;
}

template std::vector<double> natural_frequencies(const Sheet<2>&, const std::vector<int>&, double,
                                                 int);
template std::vector<double> natural_frequencies(const Sheet<3>&, const std::vector<int>&, double,
                                                 int);

}  // namespace washtub
